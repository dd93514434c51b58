// SPDX-License-Identifier: LGPL-2.1-or-later
#pragma once

#include <string>
#include <string_view>
#include <vector>

namespace whipple
{
  /// "did you mean 'Diameter'? allowed are Center, Diameter, ...": the choices a wrong name had, the nearest one
  /// (fewest single-character edits, case ignored) first if it is near at all. For error messages.
  std::string
  name_choices(std::string_view wrong, const std::vector<std::string> &allowed);
} // namespace whipple
