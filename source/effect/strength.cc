// SPDX-License-Identifier: LGPL-2.1-or-later
#include <whipple/effect/effect.h>

namespace whipple
{
  namespace
  {
    /// Shock pressure / yield stress that leaves no room for strength.
    constexpr double least_stress_ratio = 1e4;

    EffectVerdict
    judge(const SceneOutlook &outlook)
    {
      if (!outlook.any_has(&Material::strength))
        return off_without_model("Strength");
      if (!outlook.is_known())
        return kept_unknown();
      const double ratio = outlook.least(&Encounter::stress);
      const bool   on    = ratio < least_stress_ratio;
      return {"", on, ratio,
              std::string("shock pressure / yield stress") +
                  (on ? ": flow stops, and holes and craters end, where the pressure has fallen to the yield stress"
                      : ": hydrodynamic throughout")};
    }

    template <int dim>
    std::vector<FieldDescription>
    fields_of()
    {
      std::vector<FieldDescription> fields;
      for (const char *component : DeviatorStorage<dim>::field)
        fields.push_back({component, "Mbar", Carrier::volume});
      fields.push_back({"plastic strain", "1", Carrier::mass});
      return fields;
    }

    const StepOptionRegistration registration({
        .name    = "strength",
        .summary = "elastic-plastic flow: deviatoric stress with radial return to the yield surface",
        .documentation =
            "Shear stress of the solid, turned with the material (Jaumann rate), limited by the yield stress "
            "of the material's strength model, scaled with 1 - phi. Matters where the shock pressure is no "
            "more than some ten times the yield stress, and late, when the pressure is gone.",
        .fields    = fields_of<2>(),
        .family    = "Strength",
        .judge     = judge,
        .leave_out = [](Material &material) { material.strength = nullptr; },
    });
  } // namespace
} // namespace whipple
