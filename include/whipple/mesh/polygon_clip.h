// SPDX-License-Identifier: LGPL-2.1-or-later
#pragma once

#include <whipple/mesh/cell_geometry.h>
#include <whipple/mesh/index.h>

#include <array>
#include <span>

/// Convex polygons that carry a linear velocity, clipped exactly against boxes, and their moments.
namespace whipple::projection
{
  /// Vertex of a polygon with the value there of a field that is linear inside.
  struct Vertex
  {
    Vector<2> x{}; ///< cm; r, z in axisymmetry
    Vector<2> u{}; ///< cm/us
  };

  /// A convex polygon, counter-clockwise. A triangle clipped by the four sides of a box has at most seven
  /// vertices; where round-off makes edges along a side wiggle, no more than 13 (each cut: n to 3 n / 2).
  struct Polygon
  {
    int                    size = 0;
    std::array<Vertex, 13> vertex{};
  };

  using Triangle = std::array<Vertex, 3>;

  /// Twice the signed area, cm^2; positive counter-clockwise.
  double
  signed_double_area(const Triangle &triangle);

  /// The triangle as a polygon.
  Polygon
  as_polygon(const Triangle &triangle);

  /// Bounding box of triangles.
  void
  bounds(std::span<const Triangle> triangles, Vector<2> &lower, Vector<2> &upper);

  /// The triangle cut by lower <= x <= upper; size 0 where they do not overlap. Values at new vertices are
  /// interpolated along the cut edge, so a uniform field keeps its bits.
  /// Orientation is kept: turn a clockwise triangle first.
  Polygon
  clip(const Triangle &triangle, const Vector<2> &lower, const Vector<2> &upper);

  /// Integrals over a polygon with weight w = 1 (planar) or 2 pi r, exact for what they integrate.
  struct Moments
  {
    double                   volume = 0; ///< int w dA
    Vector<2>                mean_x{};   ///< int w x dA / volume
    Vector<2>                mean_u{};   ///< int w u dA / volume
    std::array<Vector<2>, 2> xx{};       ///< int w (x - mean x)(x - mean x) dA
    std::array<Vector<2>, 2> ux{};       ///< int w (u - mean u)(x - mean x) dA
    double                   uu = 0;     ///< int w |u - mean u|^2 dA
  };

  /// Moments of a polygon about its own means (a fan of triangles from its first vertex); all terms are
  /// sums without cancellation for r >= 0, so they hold at the axis too. volume = 0 leaves the rest 0.
  Moments
  moments(Symmetry symmetry, const Polygon &polygon);

  /// A quadrilateral (lexicographic corners) as two counter-clockwise triangles: along the diagonal for which
  /// the smaller signed area is larger, so that a non-convex element is cut at its reflex corner. An element
  /// that folds over itself has an inverted triangle whatever the diagonal: that triangle is turned over
  /// (it covers what it covers) and `folded` is set.
  struct Bisection
  {
    std::array<Triangle, 2> triangle;
    bool                    folded = false;
  };
  Bisection
  bisect(const CornerVectors<2> &x, const CornerVectors<2> &u);

  /// The triangle shrunk about the centroid of its area: x <- c x + (1 - c) centroid (equation (10) of 1993).
  /// By Pappus its volume of revolution shrinks by c^2 exactly.
  Triangle
  shrink(const Triangle &triangle, double c);
} // namespace whipple::projection
