// SPDX-License-Identifier: LGPL-2.1-or-later
#pragma once

#include <whipple/scene/shape.h>

namespace whipple
{
  /// True volume [cm^3] of the part of a shape inside the axis-aligned cell [lower, upper]: per cm of depth in
  /// planar symmetry, 2 pi included in axisymmetry. Exact to round-off, so that the cells of any mesh that
  /// covers a body sum to its volume.
  ///
  /// Sphere in axisymmetry: pi * integral over z of (min(r_1, s(z))^2 - r_0^2), s^2 = R^2 - (z - z_c)^2, a cubic
  /// between the z where s crosses r_0 and r_1. Circle in planar symmetry: area by circular segments. Polygons: their
  /// triangles cut by the cell, and int r dA of what is left (Pappus).
  /// A cell wholly inside a shape gives Element::volume of the cell, bit for bit.
  /// @pre lower <= upper; in axisymmetry lower[0] >= 0 and the sphere's center is on the axis.
  template <int dim>
  double
  body_volume(Symmetry symmetry, const Shape<dim> &shape, const Vector<dim> &lower, const Vector<dim> &upper);
} // namespace whipple
