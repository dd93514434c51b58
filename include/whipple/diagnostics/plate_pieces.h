// SPDX-License-Identifier: LGPL-2.1-or-later
#pragma once

#include <whipple/diagnostics/plate_image.h>
#include <whipple/mesh/index.h>
#include <whipple/scene/plate_shape.h>

#include <algorithm>
#include <vector>

namespace whipple
{
  /// What of a scene its plate's measures depend on.
  struct PlateSite
  {
    Symmetry  symmetry = Symmetry::planar;
    Vector<2> origin{};     ///< lower corner of the domain, cm
    double    spacing = 1;  ///< edge of a finest cell, cm
    int       columns = 0;  ///< finest cells along axis 0 of the domain
    Plate<2>  plate;        ///< as it entered
    double    mass = 0;     ///< g that entered the domain
    bool      half = false; ///< the left side is the axis or a plane of symmetry: half the plate is there

    /// Left and right end of the domain along axis 0, cm.
    double
    left() const
    {
      return origin[0];
    }
    double
    right() const
    {
      return origin[0] + columns * spacing;
    }
    /// Where the plate in the domain ended on side 0 (left) or 1 (right) when it entered, cm.
    double
    rim(int side) const
    {
      if (side == 1)
        return std::min(plate.half_width, right());
      return half ? left() : std::max(-plate.half_width, left());
    }
    /// Whether it reached that side of the domain.
    bool
    reaches(int side) const
    {
      return side == 1 ? plate.half_width >= right() - 1e-6 * spacing
                       : half || -plate.half_width <= left() + 1e-6 * spacing;
    }
  };

  /// What belongs together in a plate's image (doc/theory/measures.md, "Attached and detached").
  struct PlatePieces
  {
    std::vector<int>  piece; ///< of each cell of the image: the smallest index of a cell in its piece; none: not solid
    std::vector<bool> skin;  ///< partly filled cells on the surface of what is attached
    /// Pieces that hold the plate's left and right rim; none where it is lost, and on the left of half a plate.
    int left = none, right = none;

    bool
    attached(int cell) const
    {
      return piece[cell] != none && (piece[cell] == left || piece[cell] == right);
    }
  };

  /// Find the pieces of a plate and those that are attached to its rims.
  PlatePieces
  plate_pieces(const PlateSite &site, const PlateImage &image);
} // namespace whipple
