// SPDX-License-Identifier: LGPL-2.1-or-later
#include <whipple/error.h>
#include <whipple/material/material_factory.h>
#include <whipple/material/material_library.h>
#include <whipple/problem/model_constant.h>
#include <whipple/problem/problem_sections.h>

#include <algorithm>

namespace whipple::sections
{
  namespace
  {
    const std::string path = "Materials";

    /// "none | perfectly plastic | linear hardening"
    std::vector<std::string>
    choices(const ModelFamily &family)
    {
      std::vector<std::string> names;
      if (!family.absence.empty())
        names.push_back("none");
      for (const ModelDescription &model : family.models)
        names.push_back(model.name);
      return names;
    }

    std::string
    alternatives(const ModelFamily &family)
    {
      std::string text;
      for (const std::string &name : choices(family))
        text += (text.empty() ? "" : " | ") + name;
      return text;
    }

    MaterialRequest
    read_request(const SceneSection &section, const std::string &name)
    {
      MaterialRequest request;
      request.library = section.text("Library");
      if (request.library.empty())
        request.name = name;
      else
        section.name_index("Library", request.library, material_names());
      for (const ModelFamily &family : model_families())
        {
          const std::vector<std::string> names = choices(family);
          request.*family.choice               = names[section.name_index(family.key, section.text(family.key), names)];
        }
      for (const ModelConstant &constant : all_model_constants())
        if (section.given(constant.key))
          {
            if (constant.quantity == "text")
              request.texts[constant.key] = section.text(constant.key);
            else
              request.constants[constant.key] = read_constant(section, constant);
          }
      request.isothermal = section.choice<bool>("Isothermal", {{"false", false}, {"true", true}});
      return request;
    }

    /// Constants that library material and chosen models determine, made explicit in request and parameters.
    void
    fill_constants(const SceneSection &section, MaterialRequest &request)
    {
      for (const ModelFamily &family : model_families())
        if (const ModelDescription *model = chosen_model(family, request))
          for (const ModelConstant &constant : model->constants)
            {
              if (request.constants.count(constant.key) || constant.optional || constant.quantity == "text")
                continue;
              const auto published = published_constant(*model, request.library, constant.key);
              const auto value     = published ? published : constant.default_value;
              if (!value)
                continue;
              request.constants[constant.key] = *value;
              section.replace(constant.key, written(constant, *value));
            }
    }
  } // namespace

  void
  declare_materials(SceneParameters &parameters, const std::vector<std::string> &names)
  {
    SceneSection(parameters, path).declare("List", "", "names of the materials; each has its subsection below");
    for (const std::string &name : names)
      {
        SceneSection section(parameters, path + "/" + name);
        section.declare("Library", "", "material whose published constants fill what is not given here");
        for (const ModelFamily &family : model_families())
          section.declare(family.key, family.absence.empty() ? "mie-grueneisen" : "none", alternatives(family));
        for (const ModelConstant &constant : all_model_constants())
          section.declare(constant.key, "", constant.documentation);
        section.declare("Isothermal", "false", "true: the pressure does not feel the energy (1993)");
      }
  }

  template <int dim>
  void
  read_materials(SceneParameters &parameters, Problem<dim> &problem)
  {
    for (const std::string &name : SceneSection(parameters, path).list("List"))
      {
        const SceneSection section(parameters, path + "/" + name);
        SceneMaterial      material{name, read_request(section, name)};
        Material           complete;
        try
          {
            complete = make_material(material.request);
          }
        catch (const InputError &error)
          {
            section.reject("Equation of state", error.what());
          }
        fill_constants(section, material.request);
        problem.scene.materials.push_back(material);
        problem.materials.push_back({complete, complete});
      }
  }

  template void
  read_materials(SceneParameters &, Problem<2> &);
} // namespace whipple::sections
