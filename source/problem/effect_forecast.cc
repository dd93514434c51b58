// SPDX-License-Identifier: LGPL-2.1-or-later
#include <whipple/effect/effect.h>
#include <whipple/problem/effect_forecast.h>

#include <algorithm>
#include <map>

namespace whipple
{
  namespace
  {
    template <int dim>
    SceneOutlook
    outlook_of(const Problem<dim> &problem)
    {
      SceneOutlook      outlook;
      const Scene<dim> &scene = problem.scene;
      for (std::size_t m = 0; m < scene.materials.size(); ++m)
        outlook.materials.push_back({scene.materials[m].name, problem.materials[m].complete});
      outlook.encounter       = extreme_encounters(problem);
      outlook.joined_duration = joined_duration(scene);
      outlook.finest_cell     = scene.lattice.spacing;
      std::map<std::size_t, int> bodies;
      outlook.bodies_alike = 0;
      for (const Body<dim> &body : scene.bodies)
        outlook.bodies_alike = std::max(outlook.bodies_alike, ++bodies[body.material]);
      outlook.flies_as_elements = scene.stages.size() > 1 &&
                                  std::any_of(scene.stages.begin(), scene.stages.end(),
                                              [](const Stage &stage) { return stage.mode() == StageMode::lagrangian; });
      return outlook;
    }

    /// Verdicts whose effects need others that are off go off with them.
    void
    settle_dependencies(std::vector<EffectVerdict> &verdicts)
    {
      for (const EffectDescription &effect : effect_descriptions())
        for (const std::string &other : effect.requires_on)
          {
            const auto find = [&](const std::string &name) {
              return std::find_if(verdicts.begin(), verdicts.end(),
                                  [&](const EffectVerdict &v) { return v.name == name; });
            };
            const auto own = find(effect.name);
            if (own->on && !find(other)->on)
              {
                own->on = false;
                own->reason += "; off with '" + other + "'";
              }
          }
    }
  } // namespace

  template <int dim>
  std::vector<EffectVerdict>
  forecast_effects(const Problem<dim> &problem)
  {
    const SceneOutlook         outlook = outlook_of(problem);
    std::vector<EffectVerdict> verdicts;
    for (const EffectDescription &effect : effect_descriptions())
      {
        verdicts.push_back(effect.judge ? effect.judge(outlook)
                                        : EffectVerdict{"", false, {}, "not judged: list it to have it"});
        verdicts.back().name = effect.name;
      }
    settle_dependencies(verdicts);
    return verdicts;
  }

  std::string
  effect_line(const EffectVerdict &verdict)
  {
    const auto padded = [](std::string text, std::size_t width) {
      text.resize(std::max(text.size(), width), ' ');
      return text;
    };
    return "  " + padded(verdict.name, 16) + (verdict.on ? " on   " : " off  ") +
           padded(verdict.number ? rounded(*verdict.number) : "-", 10) + ' ' + verdict.reason;
  }

  template std::vector<EffectVerdict>
  forecast_effects(const Problem<2> &);
} // namespace whipple
