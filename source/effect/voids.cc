// SPDX-License-Identifier: LGPL-2.1-or-later
#include <whipple/effect/effect.h>
#include <whipple/error.h>

namespace whipple
{
  namespace
  {
    /// Tension / spall strength from which pores open; waves focus, so well below 1.
    constexpr double least_tension = 0.5;

    EffectVerdict
    judge(const SceneOutlook &outlook)
    {
      if (!outlook.any_has(&Material::void_law))
        return off_without_model("Void law");
      const double ratio = outlook.largest(&Encounter::tension);
      if (outlook.is_porous())
        return {"", true, {}, "a material is porous"};
      if (outlook.flies_as_elements)
        return {"", true, ratio, "tension / spall strength; debris flies on a moving mesh, whose elements hold voids"};
      if (!outlook.is_known())
        return kept_unknown();
      const bool on = ratio > least_tension;
      return {"", on, ratio, std::string("tension / spall strength") + (on ? ": pores open" : ": stays sound")};
    }

    void
    check(const std::vector<NamedMaterial> &materials, const std::function<bool(const std::string &)> &is_on)
    {
      if (is_on("voids"))
        return;
      for (const NamedMaterial &material : materials)
        if (const auto &law = material.model.void_law; law && law->initial_void_fraction() > 0.)
          throw InputError("material '" + material.name + "' is porous ('" + law->name() +
                           "'): add the effect 'voids', or choose another void law");
    }

    const StepOptionRegistration registration({
        .name    = "voids",
        .summary = "pores inside the material: spall, distension and recompaction by a void law",
        .documentation =
            "The void fraction phi of the mixture theory, one more number a cell; the material's void law "
            "says how it opens in tension and closes in compression. Debris needs it: on the moving mesh the "
            "space between fragments is phi.",
        .family    = "Void law",
        .judge     = judge,
        .leave_out = [](Material &material) { material.void_law = nullptr; },
        .check     = check,
    });
  } // namespace
} // namespace whipple
