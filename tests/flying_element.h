// SPDX-License-Identifier: LGPL-2.1-or-later
#pragma once

#include <whipple/mesh/cell_geometry.h>
#include <whipple/projection/element.h>

namespace whipple
{
  /// A rectangle of one material in flight, for tests of what flies: [lower, lower + extent] cm, solid of `density`
  /// [g/cm^3] and `energy` [Mbar cm^3/g] with voids phi, all corners with one velocity [cm/us].
  inline Element<2>
  flying_rectangle(const CellPacketLayout<2> &layout, Symmetry symmetry, const Vector<2> &lower,
                   const Vector<2> &extent, double density, double energy, double phi, const Vector<2> &velocity)
  {
    Element<2> element;
    element.packet.assign(layout.size(), 0.);
    for (int d = 0; d < 2; ++d)
      for (int k = 0; k < 4; ++k)
        {
          element.position[d][k]                = lower[d] + (k >> d & 1 ? extent[d] : 0.);
          element.packet[layout.velocity(d, k)] = velocity[d];
        }
    const double volume                     = cell_volume<2>(symmetry, element.position);
    element.packet[layout.volume(0)]        = volume;
    element.packet[layout.density(0)]       = density * (1. - phi);
    element.packet[layout.mass(0)]          = density * (1. - phi) * volume;
    element.packet[layout.energy(0)]        = energy;
    element.packet[layout.void_fraction(0)] = phi;
    for (double &mass : element.corner_mass)
      mass = 0.25 * element.packet[layout.mass(0)];
    return element;
  }
} // namespace whipple
