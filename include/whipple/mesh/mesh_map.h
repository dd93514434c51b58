// SPDX-License-Identifier: LGPL-2.1-or-later
#pragma once

#include <whipple/mesh/index.h>

#include <cmath>
#include <numbers>

namespace whipple
{
  /// Where the nodes of a moving mesh start.
  enum class MeshMap
  {
    identity, ///< on the lattice
    saltzman, ///< sheared along the longer axis of the domain, to try whether skewed cells keep a plane wave plane
    polar     ///< axis 0 of the lattice is the distance from the origin, axis 1 the angle above the equator
  };

  /// Place of a lattice point of the domain [lower, upper] under a map; the domain's sides stay coordinate lines.
  ///
  /// Saltzman, with L the longer edge of the domain, along xi, W the shorter one, along eta, both from `lower`:
  ///     xi' = xi + (W - eta) sin(pi xi / L),
  /// with L = 1, W = 0.1 that of [Saltzman1985]. One to one if pi W < L.
  ///
  /// Polar, with radius r = x_0 and angle phi = pi/2 (x_1 - lower_1) / (upper_1 - lower_1):
  ///     (r cos phi, r sin phi),
  /// so that the lower side of axis 1 is the equator and its upper side the axis of (r, z).
  inline Vector<2>
  mapped_point(MeshMap map, const Vector<2> &lower, const Vector<2> &upper, const Vector<2> &x)
  {
    switch (map)
      {
      case MeshMap::saltzman:
        {
          const int    along = upper[1] - lower[1] >= upper[0] - lower[0] ? 1 : 0, across = 1 - along;
          const double part = (x[along] - lower[along]) / (upper[along] - lower[along]);
          Vector<2>    y    = x;
          if (part > 0 && part < 1) // the ends stay, to the last bit
            y[along] += (upper[across] - x[across]) * std::sin(std::numbers::pi * part);
          return y;
        }
      case MeshMap::polar:
        {
          const double part = (x[1] - lower[1]) / (upper[1] - lower[1]), phi = 0.5 * std::numbers::pi * part;
          if (part >= 1) // the axis is the axis, to the last bit
            return {{0., x[0]}};
          return {{x[0] * std::cos(phi), x[0] * std::sin(phi)}};
        }
      case MeshMap::identity:
        break;
      }
    return x;
  }
} // namespace whipple
