// SPDX-License-Identifier: LGPL-2.1-or-later
#include <whipple/effect/effect.h>
#include <whipple/error.h>
#include <whipple/hydro/deviator.h>
#include <whipple/hydro/solid_state.h>

namespace whipple
{
  namespace
  {
    /// Damage of every material that has a failure model, at the end of each step.
    class FailurePass : public EffectPass<2>
    {
    public:
      explicit FailurePass(const EffectSetup<2> &setup)
        : materials_(setup.materials)
        , damage_(setup.field("damage"))
        , true_density_(setup.mesh.n_cells)
        , solid_pressure_(setup.mesh.n_cells)
        , equivalent_stress_(setup.mesh.n_cells)
        , plastic_increment_(setup.mesh.n_cells)
      {
      }

      void
      advance(const EffectStep<2> &step) override
      {
        for (std::size_t m = 0; m < materials_.size(); ++m)
          if (materials_[m].failure)
            advance_material(step.state, step.derived.material[m].pressure, step.before.material[m], step.dt, m);
      }

    private:
      void
      advance_material(State<2> &state, const std::vector<double> &pressure, const MaterialWork<2> &before, double dt,
                       std::size_t m)
      {
        MaterialState &material = state.material[m];
        solid_state::true_density(material.density, material.void_fraction, materials_[m].eos->reference_density(),
                                  true_density_);
        solid_state::pressure(pressure, material.void_fraction, solid_pressure_);
        FailureInput input{true_density_, material.energy, solid_pressure_, material.void_fraction, {}, {}, dt};
        if (materials_[m].strength)
          {
            measure_plastic_flow(state, material, before);
            input.equivalent_stress = equivalent_stress_;
            input.plastic_increment = plastic_increment_;
          }
        std::vector<double> &damage = material.fields[damage_].value;
        materials_[m].failure->advance(input, damage);
        for (Index c = 0; c < state.n_cells(); ++c)
          damage[c] = material.mass[c] > 0 ? damage[c] : 0.;
      }

      void
      measure_plastic_flow(const State<2> &state, const MaterialState &material, const MaterialWork<2> &before)
      {
        const StoredDeviator<2> stress(material, state.index);
        const auto             &strain = material.fields[state.index.plastic_strain].value;
        for (Index c = 0; c < state.n_cells(); ++c)
          {
            equivalent_stress_[c] = stress.at(c).equivalent();
            plastic_increment_[c] = strain[c] - before.plastic_strain[c];
          }
      }

      const std::vector<Material> &materials_;
      int                          damage_;
      std::vector<double>          true_density_, solid_pressure_, equivalent_stress_, plastic_increment_;
    };

    /// Tension / spall strength from which material breaks; waves focus, so well below 1.
    constexpr double least_tension = 0.5;

    EffectVerdict
    judge(const SceneOutlook &outlook)
    {
      if (!outlook.any_has(&Material::failure))
        return off_without_model("Failure");
      if (!outlook.is_known())
        return kept_unknown();
      const double ratio = outlook.largest(&Encounter::tension);
      const bool   on    = ratio > least_tension;
      return {"", on, ratio,
              std::string("tension / spall strength") + (on ? ": what breaks must stay broken" : ": nothing breaks")};
    }

    /// Without strength a model that goes by plastic strain would have nothing to go by.
    void
    check(const std::vector<NamedMaterial> &materials, const std::function<bool(const std::string &)> &is_on)
    {
      if (!is_on("failure") || is_on("strength"))
        return;
      for (const NamedMaterial &material : materials)
        if (const auto &failure = material.model.failure; failure && failure->needs_strength())
          throw InputError("'failure' of material '" + material.name + "' ('" + failure->name() +
                           "') goes by plastic strain: add the effect 'strength', or choose another failure model");
    }

    const EffectRegistration<2> registration(
        10,
        {
            .name    = "failure",
            .summary = "damage: what has failed stays without tensile strength and without yield stress",
            .documentation =
                "A damage D, 0 sound ... 1 failed, that never heals, from the material's failure model. Spall "
                "strength and yield stress are scaled with 1 - D. Without this effect a void that closes is "
                "sound material again. Graded cohesion breaks the bonds of what has failed.",
            .fields      = {{"damage", "1", Carrier::mass}},
            .family      = "Failure",
            .requires_on = {"voids"},
            .judge       = judge,
            .leave_out   = [](Material &material) { material.failure = nullptr; },
            .check       = check,
        },
        [](const EffectSetup<2> &setup) { return std::make_unique<FailurePass>(setup); });
  } // namespace
} // namespace whipple
