// SPDX-License-Identifier: LGPL-2.1-or-later
#include <whipple/effect/effect.h>

namespace whipple
{
  namespace
  {
    const EffectRegistration<2> registration({
        .name    = "strength",
        .summary = "elastic-plastic flow: deviatoric stress with radial return to the yield surface",
        .documentation =
            "Shear stress of the solid, turned with the material (Jaumann rate), limited by the yield stress "
            "of the material's strength model, scaled with 1 - phi. Matters where the shock pressure is no "
            "more than some ten times the yield stress, and late, when the pressure is gone. Its work is "
            "part of the Lagrange step.",
        .fields      = {{"deviatoric stress 00", "Mbar", Carrier::volume},
                        {"deviatoric stress 11", "Mbar", Carrier::volume},
                        {"deviatoric stress 01", "Mbar", Carrier::volume},
                        {"plastic strain", "1", Carrier::mass}},
        .family      = "Strength",
        .requires_on = {},
    });
  } // namespace
} // namespace whipple
