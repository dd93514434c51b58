// SPDX-License-Identifier: LGPL-2.1-or-later
#pragma once

#include <string>

namespace whipple
{
  /// A wall-clock time for people: 0.042 -> "0.042 s", 75 -> "1 min 15 s", 5400 -> "1 h 30 min".
  std::string
  duration(double seconds);
} // namespace whipple
