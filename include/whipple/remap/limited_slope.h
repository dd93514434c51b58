// SPDX-License-Identifier: LGPL-2.1-or-later
#pragma once

#include <algorithm>
#include <cmath>

namespace whipple
{
  /// Slope of a profile inside a cell: `central`, but at most twice either one-sided difference, so that the values at
  /// both edges of the cell lie between the neighbours; 0 at extrema (van Leer's monotonised central difference).
  inline double
  limited_slope(const double below, const double above, const double central)
  {
    const double bound = std::min(2. * std::min(std::abs(below), std::abs(above)), std::abs(central));
    return below * above > 0 ? std::copysign(bound, below) : 0.;
  }

  /// What a parabola through three cells of one size adds to the central difference, so that a straight profile of the
  /// corrected slope has the parabola's mean over the part that leaves (third order; doc/theory/remap.md).
  /// @param upstream, downstream one-sided differences along the flow   @param kept 1 - share of the cell that leaves
  inline double
  curvature_slope(const double upstream, const double downstream, const double kept)
  {
    return (downstream - upstream) * (2. * kept - 1.) / 6.;
  }
} // namespace whipple
