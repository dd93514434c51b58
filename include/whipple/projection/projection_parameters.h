// SPDX-License-Identifier: LGPL-2.1-or-later
#pragma once

/// What a scene says of the projections: plain data.
namespace whipple
{
  /// When a cell lets go of its neighbours (graded cohesion; doc/theory/projection.md).
  struct BreakCriteria
  {
    double damage        = 0.5;  ///< broken from this damage of the cell's heaviest material on
    double void_fraction = 0.15; ///< without a damage field: broken above this share of voids in the cell
    double shape         = 0.2;  ///< broken when a corner's Jacobian falls below this part of the four corners' mean
  };
} // namespace whipple
