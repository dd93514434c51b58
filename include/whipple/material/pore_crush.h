// SPDX-License-Identifier: LGPL-2.1-or-later
#pragma once

#include <whipple/material/equation_of_state.h>

#include <cmath>
#include <cstddef>
#include <span>

namespace whipple
{
  /// The crush curve of the P-alpha law in the variable x = [(alpha - 1) / (alpha0 - 1)]^(1/2), alpha = 1 / (1 - phi),
  /// in which it is a straight line: P = P_c - (P_c - P_e) x (doc/theory/voids.md).
  struct CrushCurve
  {
    double distension; ///< alpha0 - 1, > 0
    double loose;      ///< phi beyond which pores are younger than the material, and the curve says nothing
    double closed;     ///< P_c, Mbar: no pore is left
    double fall;       ///< P_c - P_e, Mbar, > 0

    /// x of a void fraction.
    double
    place(double phi) const
    {
      return std::sqrt(phi / ((1. - phi) * distension));
    }

    /// Bulk pressure P [Mbar] on the curve.
    double
    pressure(double x) const
    {
      return closed - fall * x;
    }

    /// True for a cell with pores of the material whose bulk pressure is above the curve.
    bool
    crushes(double phi, double solid_pressure) const
    {
      return (phi > 0.) & (phi <= loose) & ((1. - phi) * solid_pressure > pressure(place(phi)));
    }
  };

  /// Cells are taken in blocks that fit the first-level cache; nothing is allocated.
  inline constexpr std::size_t crush_block_length = 256;

  /// In every entry above the curve reduce phi, in place, to the one that lies on it at the same bulk density and
  /// energy, or to exactly 0. An entry's result depends on that entry alone; all others, those with rho <= 0 and those
  /// whose pressure is not a number keep their bits. At most crush_block_length entries.
  ///
  /// @param solid_pressure P_s [Mbar] of the entries as they are.
  void
  crush_pores(const EquationOfState &eos, const CrushCurve &curve, std::span<const double> bulk_density,
              std::span<const double> energy, std::span<const double> solid_pressure, std::span<double> void_fraction);

  /// Largest true density at which an equation of state is asked for pressures: just below its pole.
  inline double
  largest_trial_density(const EquationOfState &eos)
  {
    constexpr double below_pole = 1. - 1e-6;
    return below_pole * eos.max_density();
  }
} // namespace whipple
