// SPDX-License-Identifier: LGPL-2.1-or-later
#include <whipple/effect/effect.h>
#include <whipple/material/softened_strength.h>

#include <algorithm>
#include <memory>

namespace whipple
{
  namespace
  {
    /// Energy / melt onset from which results change: where flow concentrates it is heated ten times as much.
    constexpr double least_melt_share = 0.02;

    EffectVerdict
    judge(const SceneOutlook &outlook)
    {
      if (!outlook.any_has(&Material::thermal))
        return off_without_model("Thermal model");
      if (!outlook.is_known())
        return kept_unknown();
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
      return {"", on, ratio, what};
    }

    /// Voids open in the melt; strength that does not know the temperature falls with it.
    void
    take_up(Material &material)
    {
      if (!material.thermal)
        return;
      material.melts = true;
      if (material.strength && !material.strength->softens())
        material.strength = std::make_shared<SoftenedStrength>(material.strength, material.thermal);
    }

    const StepOptionRegistration registration({
        .name    = "melting",
        .summary = "temperature and melt fraction, and what they do to strength and spall",
        .documentation =
            "Strength falls with temperature to nothing in the melt, and voids open in the melt under any "
            "tension. Temperature, melt and vapour fraction are functions of density and energy: nothing "
            "is carried for them, fields and debris results show them. Without this effect a hot material is "
            "as strong as a cold one, unless its strength model knows the temperature itself.",
        .family  = "Thermal model",
        .judge   = judge,
        .take_up = take_up,
    });
  } // namespace
} // namespace whipple
