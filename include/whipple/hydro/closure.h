// SPDX-License-Identifier: LGPL-2.1-or-later
#pragma once

#include <whipple/hydro/pack.h>

#include <span>

/// Mixed cells: how a change of the cell's volume is shared between open void and materials.
/// Equations: doc/theory/lagrange_step.md, section "Mixed cells".
namespace whipple::closure
{
  /// Open void up to this share of the cell's volume counts as none: what interface reconstruction leaves
  /// behind when a cell is full.
  inline constexpr double closed_share = 1e-9;

  /// Share of the cell from which on material under pressure begins to resist although there is void left.
  inline constexpr double resisting_share = 0.95;

  /// Part w of a compression -dV of a cell with open void that its materials take, -sum dV_m = w (-dV); the pressure
  /// on the nodes is w times that of the materials, so that work and change of volume agree:
  ///
  ///     w = max(1 - o / strain, f S((f - 0.95) / 0.05) if the materials are under pressure),   o = 1 - f,
  ///     S = 3 x^2 - 2 x^3 in [0, 1]
  ///
  /// The first term closes the void before anything is compressed. The second lets material under pressure that nearly
  /// fills the cell be compressed with it (w = f), or void that comes back with every remap would keep it from ever
  /// resisting; a little material in a cell that closes is left alone, or it would have to carry all the cell's load,
  /// and a gap in a cell closes before its two sides press on each other.
  /// @param filled f = sum V_m / V
  /// @param strain -dV / V > 0
  template <typename Number, typename Mask>
  inline Number
  compressed_share(const Number &filled, const Number &strain, const Mask &under_pressure)
  {
    const Number zero(0.), one(1.), beyond = (filled - resisting_share) / (1. - resisting_share);
    const Number x       = select(beyond < 0., zero, select(beyond > 1., one, beyond));
    const Number closing = 1. - (1. - filled) / strain;
    const Number pressed = select(under_pressure, Number(filled * x * x * (3. - 2. * x)), zero);
    return select(closing > pressed, closing, pressed);
  }

  /// One material of a mixed cell.
  struct Part
  {
    double volume;    ///< V_m > 0, cm^3
    double modulus;   ///< rho c^2 >= 0, Mbar
    double pressure;  ///< P, Mbar
    double loose = 0; ///< pressure <= 0 at which it no longer presses on open void: its least principal deviator, Mbar
  };

  /// New volumes of the materials when the cell goes from `cell_volume` to `new_cell_volume`.
  ///
  /// With open void, the materials take compressed_share() of a compression; expansion opens the void, but a material
  /// whose pressure is above `loose` expands with the cell. Without open void, all materials change their pressure by
  /// the same amount: V_m -> V_m exp(-y), y = x / K_m, and V_m / (e y) where y > 1.
  /// @param part   materials with volume > 0
  /// @param result new volumes, same order; positive if new_cell_volume is
  void
  share_volume(double cell_volume, double new_cell_volume, std::span<const Part> part, std::span<double> result);
} // namespace whipple::closure
