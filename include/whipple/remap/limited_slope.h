// SPDX-License-Identifier: LGPL-2.1-or-later
#pragma once

#include <algorithm>
#include <cmath>

namespace whipple
{
  /// Monotonised central difference (van Leer): `central`, but at most twice either one-sided difference, so that
  /// the values at both edges of the cell lie between the neighbours; 0 at extrema.
  inline double
  limited_slope(const double below, const double above, const double central)
  {
    const double bound = std::min(2. * std::min(std::abs(below), std::abs(above)), std::abs(central));
    return below * above > 0 ? std::copysign(bound, below) : 0.;
  }
} // namespace whipple
