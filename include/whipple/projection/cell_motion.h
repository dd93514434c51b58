// SPDX-License-Identifier: LGPL-2.1-or-later
#pragma once

#include <whipple/mesh/index.h>

#include <array>

namespace whipple::projection
{
  /// Mass in motion, by its moments: what parcels of debris in one cell add up to. Means and central moments, so that
  /// a small relative motion on top of a large common velocity is not lost in differences of squares,
  /// and a uniform velocity keeps its bits.
  struct Motion
  {
    double                   mass = 0;    ///< g
    Vector<2>                mean_x{};    ///< centre of mass, cm
    Vector<2>                mean_u{};    ///< cm/us
    double                   kinetic = 0; ///< energy of the motion about mean_u, Mbar cm^3
    std::array<Vector<2>, 2> xx{};        ///< int (x - mean x)(x - mean x) dm
    std::array<Vector<2>, 2> ux{};        ///< int (u - mean u)(x - mean x) dm

    /// Join another mass (parallel axes: moments about the common means, a term m1 m2/(m1 + m2) each).
    void
    add(const Motion &other);

    /// Velocity gradient L[a][b] = d u_a / d x_b of least squares, ux xx^-1. Directions along which the mass
    /// is spread less than a variance of 1e-3 size^2 (a sliver a tenth of the cell wide) get no gradient.
    std::array<Vector<2>, 2>
    gradient(double size) const;
  };
} // namespace whipple::projection
