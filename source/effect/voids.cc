// SPDX-License-Identifier: LGPL-2.1-or-later
#include <whipple/effect/effect.h>

namespace whipple
{
  namespace
  {
    const EffectRegistration<2> registration({
        .name    = "voids",
        .summary = "pores inside the material: spall, distension and recompaction by a void law",
        .documentation =
            "The void fraction phi of the mixture theory, one more number a cell; the material's void law "
            "says how it opens in tension and closes in compression. Debris needs it: on the moving mesh the "
            "space between fragments is phi. Its work is part of the Lagrange step.",
        .fields      = {},
        .family      = "Void law",
        .requires_on = {},
    });
  } // namespace
} // namespace whipple
