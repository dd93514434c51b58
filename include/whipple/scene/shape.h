// SPDX-License-Identifier: LGPL-2.1-or-later
#pragma once

#include <whipple/mesh/index.h>

#include <limits>
#include <variant>

namespace whipple
{
  /// A ball; in planar symmetry the cylinder whose cross-section it is.
  template <int dim>
  struct Sphere
  {
    Vector<dim> center{};     ///< cm
    double      diameter = 0; ///< cm
  };

  /// A flat plate normal to axis 1, around axis 0 = 0.
  template <int dim>
  struct Plate
  {
    double front      = 0;                                       ///< lower face along axis 1, cm
    double thickness  = 0;                                       ///< cm
    double half_width = std::numeric_limits<double>::infinity(); ///< |x| or r below it; infinite: the whole domain, cm
  };

  /// An axis-aligned box; in axisymmetry a (hollow) cylinder.
  template <int dim>
  struct Box
  {
    Vector<dim> lower{}; ///< cm
    Vector<dim> upper{}; ///< cm
  };

  template <int dim>
  using Shape = std::variant<Sphere<dim>, Plate<dim>, Box<dim>>;

  /// Smallest axis-aligned box around a shape; infinite where a plate is. extent(wall).lower[1] is the wall's
  /// front face, .upper[1] its rear face (debris flies towards larger axis 1).
  template <int dim>
  Box<dim>
  extent(const Shape<dim> &shape);

  /// Whether two shapes share volume; touching (to a relative 1e-12) is not sharing.
  template <int dim>
  bool
  overlap(const Shape<dim> &a, const Shape<dim> &b);
} // namespace whipple
