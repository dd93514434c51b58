// SPDX-License-Identifier: LGPL-2.1-or-later
#include <whipple/output/duration.h>

#include <array>
#include <cmath>
#include <cstdio>

namespace whipple
{
  std::string
  duration(double seconds)
  {
    constexpr double few = 10; // below, tenths matter
    if (seconds < few)
      {
        std::array<char, 32> text;
        std::snprintf(text.data(), text.size(), seconds < 1 ? "%.2g s" : "%.1f s", seconds);
        return text.data();
      }
    const long s = std::lround(seconds);
    if (s < 60)
      return std::to_string(s) + " s";
    if (s < 3600)
      return std::to_string(s / 60) + " min " + std::to_string(s % 60) + " s";
    return std::to_string(s / 3600) + " h " + std::to_string(s % 3600 / 60) + " min";
  }
} // namespace whipple
