// SPDX-License-Identifier: LGPL-2.1-or-later
#pragma once

#include <whipple/mesh/index.h>

#include <span>
#include <vector>

namespace whipple::projection
{
  /// A box of material that may become part of a fragment (doc/theory/fragments.md).
  struct Parcel
  {
    Vector<2> lower{}, upper{}; ///< of its box, cm
    double    solid = 0;        ///< area that its solid would fill, cm^2
    double    size  = 0;        ///< of the fragments there, cm

    double
    area() const
    {
      return (upper[0] - lower[0]) * (upper[1] - lower[1]);
    }
  };

  /// Numbers of the parcels that make one fragment, ascending.
  using ParcelGroup = std::vector<Index>;

  /// Sets of parcels whose boxes touch, at a side or a corner: those that are more than half solid among themselves,
  /// and the others among themselves. Ordered by their first parcel.
  std::vector<ParcelGroup>
  touching_sets(std::span<const Parcel> parcels);

  /// Cut a set in two, again and again, until each part is one fragment: its weight is nearest to 1, and its length, as
  /// if it were solid, no more than 1.5 fragment sizes (where single parcels allow it). In axisymmetry a part that
  /// touches the axis is looked at together with its mirror image. Equations: doc/theory/fragments.md. Depends on the
  /// parcels and their order only.
  std::vector<ParcelGroup>
  cut_into_fragments(Symmetry symmetry, std::span<const Parcel> parcels, const ParcelGroup &set);
} // namespace whipple::projection
