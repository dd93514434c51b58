// SPDX-License-Identifier: LGPL-2.1-or-later
#include <whipple/effect/effect.h>

namespace whipple
{
  namespace
  {
    EffectVerdict
    judge(const SceneOutlook &outlook)
    {
      const bool on = outlook.bodies_alike > 1;
      return {"", on, static_cast<double>(outlook.bodies_alike),
              std::string("bodies of one material") + (on ? ": told apart in results" : ": nothing to tell apart")};
    }

    const StepOptionRegistration registration({
        .name    = "body tags",
        .summary = "which body each gram comes from, carried through all stages",
        .documentation =
            "For every body but the last of each material the share of the mass in a cell that came from it "
            "(a field 'body NAME'): tells projectile from plate in debris of one material. Bodies of "
            "different materials need no tag.",
        .judge = judge,
    });
  } // namespace
} // namespace whipple
