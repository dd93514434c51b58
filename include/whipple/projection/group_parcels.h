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
    double    solid  = 0;       ///< area that its solid would fill, cm^2
    double    weight = 0;       ///< how much of a fragment it is: solid / s^2, more beside the axis

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

  /// Cut a set in two, again and again, until each part is one fragment: its weight is nearest to 1, and its extent, as
  /// if it were solid, no more than 1.5 fragment sizes (where single parcels allow it). Equations:
  /// doc/theory/fragments.md. Depends on the parcels and their order only.
  std::vector<ParcelGroup>
  cut_into_fragments(std::span<const Parcel> parcels, const ParcelGroup &set);
} // namespace whipple::projection
