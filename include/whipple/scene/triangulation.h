// SPDX-License-Identifier: LGPL-2.1-or-later
#pragma once

#include <whipple/mesh/index.h>

#include <array>
#include <vector>

namespace whipple
{
  /// Twice the signed area of the triangle a, b, c, cm^2; positive counter-clockwise.
  double
  turn_area(const Vector<2> &a, const Vector<2> &b, const Vector<2> &c);

  /// Signed area inside an outline, cm^2; positive counter-clockwise.
  double
  outline_area(const std::vector<Vector<2>> &corners);

  /// Disjoint counter-clockwise triangles that make up a simple polygon given counter-clockwise, by clipping ears
  /// (Meisters, Amer. Math. Monthly 82, 1975): cost grows with the square of the number of corners.
  std::vector<std::array<Vector<2>, 3>>
  triangulate(std::vector<Vector<2>> corners);
} // namespace whipple
