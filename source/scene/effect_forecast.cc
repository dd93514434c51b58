// SPDX-License-Identifier: LGPL-2.1-or-later
#include <whipple/effect/effect.h>
#include <whipple/scene/effect_forecast.h>
#include <whipple/scene/material_effects.h>

#include <algorithm>
#include <cmath>
#include <functional>
#include <map>
#include <sstream>

namespace whipple
{
  namespace
  {
    // Where an effect begins to change results by a per cent or two; the study doc/effects_auto.md tries them.
    constexpr double least_stress_ratio = 1e4; ///< shock pressure / yield stress that leaves no room for strength
    constexpr double least_melt_share =
        0.02; ///< energy / melt onset: where flow concentrates it is heated ten times as much
    constexpr double least_tension         = 0.5; ///< tension / spall strength; waves focus, so well below 1
    constexpr double least_diffusion_cells = 0.5; ///< diffusion length / cell

    template <int dim>
    struct Outlook
    {
      const Scene<dim>      &scene;
      std::vector<Encounter> encounter;       ///< highest pressure first
      double                 joined_duration; ///< us in which cells share faces: fragments of their own pass on no heat

      bool
      is_known() const
      {
        return !encounter.empty() &&
               std::all_of(encounter.begin(), encounter.end(), [](const Encounter &e) { return e.is_known; });
      }
      double
      largest(double Encounter::*number) const
      {
        double value = 0;
        for (const Encounter &e : encounter)
          value = std::max(value, e.*number);
        return value;
      }
      double
      least(double Encounter::*number) const
      {
        double value = std::numeric_limits<double>::infinity();
        for (const Encounter &e : encounter)
          value = std::min(value, e.*number);
        return value;
      }
      template <class Model>
      bool
      any_has(const Model &model) const
      {
        return std::any_of(scene.materials.begin(), scene.materials.end(),
                           [&](const SceneMaterial &m) { return model(m.complete) != nullptr; });
      }
      bool
      is_porous() const
      {
        return std::any_of(scene.materials.begin(), scene.materials.end(),
                           [](const SceneMaterial &m) { return sections::initial_void_fraction(m.complete) > 0.; });
      }
      bool
      flies() const
      {
        return std::any_of(scene.stages.begin(), scene.stages.end(),
                           [](const Stage &s) { return s.mode == StageMode::lagrangian; }) &&
               scene.stages.size() > 1;
      }
    };

    EffectVerdict
    no_model(const std::string &name, const std::string &key)
    {
      return {name, false, {}, "no material names a model (Materials/NAME/" + key + ")"};
    }

    EffectVerdict
    kept_unknown(const std::string &name)
    {
      return {name, true, {}, "kept: no one-dimensional impact to judge by"};
    }

    template <int dim>
    EffectVerdict
    strength(const Outlook<dim> &outlook)
    {
      if (!outlook.any_has([](const Material &m) { return m.strength.get(); }))
        return no_model("strength", "Strength");
      if (!outlook.is_known())
        return kept_unknown("strength");
      const double ratio = outlook.least(&Encounter::stress);
      const bool   on    = ratio < least_stress_ratio;
      return {
          "strength", on, ratio,
          "shock pressure / yield stress" +
              std::string(on ? ": flow stops, and holes and craters end, where the pressure has fallen to the yield "
                               "stress"
                             : ": hydrodynamic throughout")};
    }

    template <int dim>
    EffectVerdict
    melting(const Outlook<dim> &outlook)
    {
      if (!outlook.any_has([](const Material &m) { return m.thermal.get(); }))
        return no_model("melting", "Thermal model");
      if (!outlook.is_known())
        return kept_unknown("melting");
      // a slow impact leaves little heat behind, but plastic flow turns what is stopped into heat, in few places
      const double residual = outlook.largest(&Encounter::residual), kinetic = outlook.largest(&Encounter::kinetic);
      const double ratio = std::max(residual, kinetic);
      const bool   on    = ratio > least_melt_share;
      std::string  what  = residual > 1.        ? "energy after release / melt onset: melts on release"
                           : residual > kinetic ? "energy after release / melt onset: softens"
                                                : "kinetic energy / melt onset: plastic flow softens";
      if (!on)
        what = "kinetic energy / melt onset: stays cold";
      if (outlook.largest(&Encounter::vapour) > 1.)
        what += ", begins to boil";
      return {"melting", on, ratio, what};
    }

    template <int dim>
    EffectVerdict
    voids(const Outlook<dim> &outlook)
    {
      if (!outlook.any_has([](const Material &m) { return m.void_law.get(); }))
        return no_model("voids", "Void law");
      const double ratio = outlook.largest(&Encounter::tension);
      if (outlook.is_porous())
        return {"voids", true, {}, "a material is porous"};
      if (outlook.flies())
        return {"voids", true, ratio,
                "tension / spall strength; debris flies on a moving mesh, whose elements hold voids"};
      if (!outlook.is_known())
        return kept_unknown("voids");
      const bool on = ratio > least_tension;
      return {"voids", on, ratio, std::string("tension / spall strength") + (on ? ": pores open" : ": stays sound")};
    }

    template <int dim>
    EffectVerdict
    failure(const Outlook<dim> &outlook)
    {
      if (!outlook.any_has([](const Material &m) { return m.failure.get(); }))
        return no_model("failure", "Failure");
      if (!outlook.is_known())
        return kept_unknown("failure");
      const double ratio = outlook.largest(&Encounter::tension);
      const bool   on    = ratio > least_tension;
      return {"failure", on, ratio,
              std::string("tension / spall strength") + (on ? ": what breaks must stay broken" : ": nothing breaks")};
    }

    template <int dim>
    EffectVerdict
    heat_conduction(const Outlook<dim> &outlook)
    {
      double length = 0;
      for (const SceneMaterial &material : outlook.scene.materials)
        if (const Material &m = material.complete; m.conduction && m.thermal)
          length = std::max(length, std::sqrt(m.conduction->reference_conductivity() * outlook.joined_duration /
                                              (m.eos->reference_density() * m.thermal->specific_heat())));
      if (length == 0)
        return no_model("heat conduction", "Conduction");
      const double cells = length / outlook.scene.lattice.spacing;
      const bool   on    = cells > least_diffusion_cells;
      return {"heat conduction", on, cells,
              "diffusion length in the " + rounded(outlook.joined_duration) + " us in which cells are joined / cell" +
                  (on ? ": heat crosses cells" : ": heat stays in its cell")};
    }

    template <int dim>
    EffectVerdict
    body_tags(const Outlook<dim> &outlook)
    {
      std::map<std::size_t, int> bodies;
      int                        most = 0;
      for (const Body<dim> &body : outlook.scene.bodies)
        most = std::max(most, ++bodies[body.material]);
      return {"body tags", most > 1, static_cast<double>(most),
              std::string("bodies of one material") +
                  (most > 1 ? ": told apart in results" : ": nothing to tell apart")};
    }

    template <int dim>
    EffectVerdict
    fragment_size(const Outlook<dim> &outlook)
    {
      if (!outlook.any_has([](const Material &m) { return m.fragments.get(); }))
        return no_model("fragment size", "Fragments");
      return {"fragment size", true, {}, "a material names a model; a diagnostic, nothing feeds back"};
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
  forecast_effects(const Scene<dim> &scene)
  {
    const Outlook<dim> outlook{scene, extreme_encounters(scene), joined_duration(scene)};
    const std::map<std::string, std::function<EffectVerdict(const Outlook<dim> &)>> judges{
        {"strength", strength<dim>},
        {"melting", melting<dim>},
        {"voids", voids<dim>},
        {"failure", failure<dim>},
        {"body tags", body_tags<dim>},
        {"heat conduction", heat_conduction<dim>},
        {"fragment size", fragment_size<dim>},
    };
    std::vector<EffectVerdict> verdicts;
    for (const EffectDescription &effect : effect_descriptions())
      {
        const auto judge = judges.find(effect.name);
        verdicts.push_back(judge != judges.end()
                               ? judge->second(outlook)
                               : EffectVerdict{effect.name, false, {}, "not judged: list it to have it"});
      }
    settle_dependencies(verdicts);
    return verdicts;
  }

  std::string
  rounded(double value)
  {
    std::ostringstream text;
    text.precision(3);
    text << value;
    return text.str();
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
  forecast_effects(const Scene<2> &);
} // namespace whipple
