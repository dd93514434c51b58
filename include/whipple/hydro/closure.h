// SPDX-License-Identifier: LGPL-2.1-or-later
#pragma once

#include <array>
#include <span>

/// Mixed cells: how a change of the cell's volume is shared between open void and materials.
/// Equations: doc/theory/lagrange_step.md, section "Mixed cells".
namespace whipple::closure
{
  /// Open void up to this share of the cell's volume counts as none: what interface reconstruction leaves
  /// behind when a cell is full.
  inline constexpr double closed_share = 1e-9;

  /// One material of a mixed cell.
  struct Part
  {
    double volume;   ///< V_m > 0, cm^3
    double modulus;  ///< rho c^2 >= 0, Mbar
    double pressure; ///< P, Mbar
  };

  /// New volumes of the materials when the cell goes from `cell_volume` to `new_cell_volume`.
  ///
  /// With open void, compression closes the void first and then acts on the materials; expansion opens the
  /// void, but a material under pressure expands with the cell. Without open void, all materials change
  /// their pressure by the same amount: V_m -> V_m exp(-x / K_m).
  /// @param part   materials with volume > 0
  /// @param result new volumes, same order; positive if new_cell_volume is
  void
  share_volume(double cell_volume, double new_cell_volume, std::span<const Part> part, std::span<double> result);
} // namespace whipple::closure
