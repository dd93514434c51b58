// SPDX-License-Identifier: LGPL-2.1-or-later
#pragma once

#include <string>

namespace whipple
{
  /// Constants of material models come from users: these reject the impossible ones in one clear line,
  /// "mie-grueneisen: density = -2.7 g/cm^3: must be > 0". Not-a-number is always rejected.

  /// @throws InputError unless value is finite and > 0.
  void
  require_positive(const std::string &model, const std::string &quantity, double value, const std::string &unit);

  /// @throws InputError unless value is finite and >= 0.
  void
  require_not_negative(const std::string &model, const std::string &quantity, double value, const std::string &unit);

  /// @throws InputError unless value is finite and > bound.
  void
  require_greater(const std::string &model, const std::string &quantity, double value, double bound,
                  const std::string &unit);
} // namespace whipple
