// SPDX-License-Identifier: LGPL-2.1-or-later
#include <whipple/effect/effect.h>

namespace whipple
{
  namespace
  {
    const EffectRegistration<2> registration({
        .name    = "melting",
        .summary = "temperature and melt fraction, and what they do to strength and spall",
        .documentation =
            "Strength falls with temperature to nothing in the melt, and voids open in the melt under any "
            "tension. Temperature, melt and vapour fraction are functions of density and energy: nothing "
            "is carried for them, fields and debris results show them. Without this effect a hot material is "
            "as strong as a cold one, unless its strength model knows the temperature itself.",
        .fields      = {},
        .family      = "Thermal model",
        .requires_on = {},
    });
  } // namespace
} // namespace whipple
