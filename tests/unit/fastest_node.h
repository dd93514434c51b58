// SPDX-License-Identifier: LGPL-2.1-or-later
#pragma once

#include <whipple/state/fields.h>

#include <algorithm>
#include <cmath>

namespace whipple
{
  /// Largest velocity component of any node, cm/us.
  inline double
  fastest_node(const State<2> &state)
  {
    double speed = 0;
    for (const auto &component : state.velocity)
      for (const double v : component)
        speed = std::max(speed, std::abs(v));
    return speed;
  }
} // namespace whipple
