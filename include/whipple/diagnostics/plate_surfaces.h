// SPDX-License-Identifier: LGPL-2.1-or-later
#pragma once

#include <whipple/diagnostics/plate_pieces.h>

#include <functional>
#include <optional>
#include <vector>

/// Where the surfaces of an attached piece of a plate lie, to a part of a cell (doc/theory/measures.md, "Surfaces").
namespace whipple
{
  /// What a line of flight through a column of cells meets of a piece.
  struct PlateColumn
  {
    double x         = 0; ///< of the column's middle, cm
    double front     = 0; ///< foremost surface, cm along axis 1
    double rear      = 0; ///< rearmost surface, cm along axis 1
    double thickness = 0; ///< solid in it, cm

    double
    middle() const
    {
      return 0.5 * (front + rear);
    }
  };

  class PlateSurfaces
  {
  public:
    /// All three are kept by reference.
    PlateSurfaces(const PlateSite &site, const PlateImage &image, const PlatePieces &pieces)
      : site_(site)
      , image_(image)
      , pieces_(pieces)
    {
    }

    /// The columns that a piece reaches into, from left to right.
    std::vector<PlateColumn>
    columns(int piece) const;

    /// The surface of a piece that one meets first in a row of cells, coming from the left (or from the right), cm
    /// along axis 0; nothing where the piece does not reach into the row, or the row is cut by the faces of the plate
    /// there.
    std::optional<double>
    edge(int piece, int row, bool from_left) const
    {
      return surface(piece, 0, row, from_left);
    }

    /// How far a piece reaches to the left (or to the right) with anything, cm along axis 0.
    double
    tip(int piece, bool from_left) const;

    /// Where the edge meets the middle of the plate beside it.
    Vector<2>
    middle_of_edge(int piece, bool from_left) const;

    /// Smallest distance between the two attached pieces along any row or column, cm; infinite if no line meets both.
    double
    gap() const;

    /// Axis 1 coordinate of the middle of a row.
    double
    row_middle(int row) const
    {
      return site_.origin[1] + (row + 0.5) * site_.spacing;
    }

  private:
    /// Surface of a piece on a line along an axis, the first one from below or from above.
    std::optional<double>
    surface(int piece, int axis, int line, bool from_below) const;

    /// Solid of a piece and of the skin in a column, cm.
    double
    solid_on(int piece, int column) const;

    const PlateSite   &site_;
    const PlateImage  &image_;
    const PlatePieces &pieces_;
  };
} // namespace whipple
