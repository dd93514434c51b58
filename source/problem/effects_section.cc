// SPDX-License-Identifier: LGPL-2.1-or-later
#include <whipple/effect/effect.h>
#include <whipple/error.h>
#include <whipple/problem/effect_forecast.h>
#include <whipple/problem/material_effects.h>
#include <whipple/problem/model_constant.h>
#include <whipple/problem/problem_sections.h>
#include <whipple/projection/representation.h>
#include <whipple/refinement/refinement_criterion.h>

#include <algorithm>

namespace whipple::sections
{
  namespace
  {
    const std::string path      = "Effects";
    const std::string automatic = "auto";

    std::vector<std::string>
    effect_names()
    {
      std::vector<std::string> names;
      for (const EffectDescription &effect : effect_descriptions())
        names.push_back(effect.name);
      return names;
    }

    bool
    contains(const std::vector<std::string> &names, const std::string &name)
    {
      return std::find(names.begin(), names.end(), name) != names.end();
    }

    /// Names in the list, checked; "auto" may be one of them.
    std::vector<std::string>
    read_list(const SceneSection &section)
    {
      std::vector<std::string> allowed = effect_names(), listed;
      allowed.insert(allowed.begin(), automatic);
      for (const std::string &name : section.list("List"))
        {
          section.name_index("List", name, allowed);
          if (contains(listed, name))
            section.reject("List", "'" + name + "' is listed twice; allowed is once");
          listed.push_back(name);
        }
      return listed;
    }

    /// "strength, voids", or "" for none
    std::string
    joined(const std::vector<std::string> &names)
    {
      std::string text;
      for (const std::string &name : names)
        text += (text.empty() ? "" : ", ") + name;
      return text;
    }
  } // namespace

  void
  declare_effects(SceneParameters &parameters)
  {
    for (const EffectDescription &effect : effect_descriptions())
      for (const ModelConstant &parameter : effect.parameters)
        SceneSection(parameters, path + '/' + effect.name)
            .declare(parameter.key, parameter.default_value ? written(parameter, *parameter.default_value) : "",
                     parameter.documentation);
    SceneSection(parameters, path)
        .declare("List", "",
                 "any of: " + joined(effect_names()) +
                     "; an effect left out costs nothing and carries no field; auto: those that matter, and what is "
                     "listed beside it");
  }

  namespace
  {
    /// @throws InputError if a criterion of refinement looks at a field that no effect of the scene carries
    template <int dim>
    void
    check_criteria(SceneParameters &parameters, const Scene<dim> &scene)
    {
      for (const auto &criterion : scene.mesh.criteria)
        {
          const auto [key, wanted] = criterion->carried_field();
          bool        found        = key.empty();
          std::string names        = "density, pressure, speed, specific internal energy, void fraction";
          for (const EffectDescription &effect : effect_descriptions())
            for (const FieldDescription &field : effect.fields)
              if (scene.has_effect(effect.name))
                {
                  found = found || field.name == wanted;
                  names += ", " + field.name;
                }
          if (!found)
            SceneSection(parameters, "Mesh").reject(key, "no such field in this scene; allowed are " + names);
        }
    }

    /// @throws InputError if debris is to be laid down by what an effect tells that is not on
    template <int dim>
    void
    check_representations(SceneParameters &parameters, const Scene<dim> &scene)
    {
      for (const Stage &stage : scene.stages)
        if (const auto [key, effect] = stage.representation->needed_effect();
            !effect.empty() && !scene.has_effect(effect))
          SceneSection(parameters, "Stages/" + stage.name)
              .reject(key,
                      "needs the effect '" + effect +
                          "' (Effects/List) and a model that it belongs to in a material; else a length is allowed");
    }

    /// Parameters of all effects; those of effects that are off must be right, too, but none must be given.
    template <int dim>
    void
    read_parameters(SceneParameters &parameters, Scene<dim> &scene)
    {
      for (const EffectDescription &effect : effect_descriptions())
        for (const ModelConstant &parameter : effect.parameters)
          {
            const SceneSection section(parameters, path + '/' + effect.name);
            if (section.given(parameter.key))
              scene.effect_parameters[effect.name][parameter.key] = read_constant(section, parameter);
            else if (scene.has_effect(effect.name))
              section.reject(parameter.key, "must be given, " + parameter.range.text());
          }
    }
  } // namespace

  template <int dim>
  void
  read_effects(SceneParameters &parameters, Problem<dim> &problem)
  {
    Scene<dim>                    &scene = problem.scene;
    const SceneSection             section(parameters, path);
    const std::vector<std::string> listed = read_list(section);
    if (contains(listed, automatic))
      scene.effect_verdicts = forecast_effects(problem);
    else
      for (const std::string &name : effect_names())
        scene.effect_verdicts.push_back({name, false, {}, "not listed by the scene"});
    for (EffectVerdict &verdict : scene.effect_verdicts)
      {
        if (contains(listed, verdict.name))
          verdict = {verdict.name, true, verdict.number, "listed by the scene"};
        if (verdict.on)
          scene.effects.push_back(verdict.name);
      }
    try
      {
        check_effects(scene.materials, problem.materials, scene.effects);
        for (MaterialModels &material : problem.materials)
          material.model = with_effects(material.complete, scene.effects);
      }
    catch (const InputError &error)
      {
        section.reject("List", error.what());
      }
    if (contains(listed, automatic))
      section.replace("List", joined(scene.effects));
    read_parameters(parameters, scene);
    check_criteria(parameters, scene);
    check_representations(parameters, scene);
  }

  template void
  read_effects<2>(SceneParameters &, Problem<2> &);
} // namespace whipple::sections
