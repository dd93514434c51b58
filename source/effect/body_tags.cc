// SPDX-License-Identifier: LGPL-2.1-or-later
#include <whipple/effect/effect.h>

namespace whipple
{
  namespace
  {
    const EffectRegistration<2> registration({
        .name    = "body tags",
        .summary = "which body each gram comes from, carried through all stages",
        .documentation =
            "For every body but the last of each material the share of the mass in a cell that came from it "
            "(a field 'body NAME'): tells projectile from plate in debris of one material. Bodies of "
            "different materials need no tag.",
        .fields      = {},
        .family      = "",
        .requires_on = {},
    });
  } // namespace
} // namespace whipple
