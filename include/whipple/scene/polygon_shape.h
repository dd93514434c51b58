// SPDX-License-Identifier: LGPL-2.1-or-later
#pragma once

#include <whipple/mesh/polygon_clip.h>
#include <whipple/scene/shape.h>

#include <optional>
#include <string>
#include <vector>

namespace whipple
{
  /// What keeps corners from being the outline of a body ("edges 1 and 3 cross or touch"); empty if they are one:
  /// at least three corners, an area, edges that meet at their ends only.
  std::string
  outline_problem(const std::vector<Vector<2>> &corners);

  /// A simple polygon, convex or not: the cross-section of a body 1 cm deep, or of one of revolution.
  class PolygonShape : public ShapeGeometry<2>
  {
  public:
    /// @param corners of an outline without problem, in either sense of rotation, cm
    /// @param within what lies outside of this box does not count for the extent: the shape goes on there
    explicit PolygonShape(std::vector<Vector<2>> corners, const std::optional<Box<2>> &within = std::nullopt);

    Box<2>
    extent() const override;
    double
    volume(Symmetry symmetry, const Vector<2> &lower, const Vector<2> &upper) const override;
    bool
    contains(const Vector<2> &x) const override;
    std::vector<ConvexPart<2>>
    parts(const Box<2> &window) const override;
    /// Least way through it from the middle of an edge, normal to the edge.
    double
    least_thickness(std::span<const MirrorPlane> mirrors) const override;
    bool
    is_mirrored() const override;
    Shape<2>
    turned(const Turn<2> &turn, const Box<2> &domain) const override;

    /// Counter-clockwise, cm.
    const std::vector<Vector<2>> &
    corners() const
    {
      return corners_;
    }

  private:
    /// A triangle and its bounding box.
    struct Piece
    {
      projection::Triangle triangle;
      Box<2>               box;
    };

    std::vector<Vector<2>> corners_;
    std::vector<Piece>     pieces_; ///< disjoint triangles that make up the polygon
    std::optional<Box<2>>  within_;
    Box<2>                 extent_;
  };
} // namespace whipple
