// SPDX-License-Identifier: LGPL-2.1-or-later
#pragma once

#include <optional>
#include <string>

namespace whipple
{
  /// Whether an effect or option is on, and why.
  struct EffectVerdict
  {
    std::string           name;
    bool                  on     = false;
    std::optional<double> number = {}; ///< dimensionless, that decides; none: listed, or nothing to measure
    std::string           reason = {}; ///< one line
  };
} // namespace whipple
