// SPDX-License-Identifier: LGPL-2.1-or-later
#pragma once

#include <whipple/mesh/polygon_clip.h>
#include <whipple/projection/cell_motion.h>
#include <whipple/projection/element.h>

#include <vector>

namespace whipple::projection
{
  /// An element as the two triangles that are laid down, uniform in density, with a velocity that is linear in
  /// each.
  struct ElementPieces
  {
    std::array<Triangle, 2> triangle;        ///< counter-clockwise, r >= 0, velocities set
    double                  volume  = 0;     ///< of both triangles, true, cm^3
    double                  mass    = 0;     ///< g
    double                  unshown = 0;     ///< kinetic energy per gram that the velocities do not show
    std::vector<double>     material_volume; ///< what each material occupies once laid down, cm^3
    std::vector<double>     void_fraction;   ///< phi of each material once laid down
    bool                    folded           = false;
    int                     mirrored_corners = 0;

    /// Mass in motion in a part of the pieces.
    Motion
    motion(const Moments &part) const;
  };

  /// An element cut in two, with its voids (doc/theory/projection.md). Its momentum is exact: the linear velocities are
  /// shifted to the mean velocity of the corner masses; if they move more vigorously about it than the corner
  /// masses do, their deviations are scaled down, and if less, the difference is `unshown`.
  /// @throws StateError if the element has no volume or no mass.
  ElementPieces
  distended_pieces(Symmetry symmetry, const CellPacketLayout<2> &layout, const Element<2> &element);

  /// An element cut in two, each triangle shrunk about its centroid by (1 - phi)^(1/2): solid at its true density, with
  /// one velocity; the kinetic energy about it is `unshown`.
  /// @throws StateError if the element has no volume or no mass.
  ElementPieces
  solid_pieces(Symmetry symmetry, const CellPacketLayout<2> &layout, const Element<2> &element);

  /// An element's corners, and what they amount to.
  struct ElementCorners
  {
    CornerVectors<2> x{}, u{};             ///< r >= 0: what has crossed the axis is on its other side, the same ring
    int              mirrored_corners = 0; ///< those that had crossed it
    Motion           motion; ///< of the corner masses; kinetic: about their mean, and what they do not show
  };
  ElementCorners
  corners_of(Symmetry symmetry, const CellPacketLayout<2> &layout, const Element<2> &element);

  /// Corner positions with r >= 0: material that has crossed the axis is on its other side, the same ring.
  CornerVectors<2>
  mirrored(Symmetry symmetry, CornerVectors<2> x);
} // namespace whipple::projection
