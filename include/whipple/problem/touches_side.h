// SPDX-License-Identifier: LGPL-2.1-or-later
#pragma once

#include <whipple/scene/scene.h>

namespace whipple
{
  /// Whether a body, as it enters, reaches a side of the domain, or misses it by no more than a part of the domain's
  /// extent across that side.
  template <int dim>
  bool
  touches_side(const Scene<dim> &scene, const Body<dim> &body, int side, double part)
  {
    const int      axis = side / 2;
    const Box<dim> box  = extent(body.shape);
    const double   low = scene.lattice.origin[axis], high = scene.upper_corner()[axis];
    const double   slack = part * (high - low);
    return side % 2 ? box.upper[axis] >= high - slack : box.lower[axis] <= low + slack;
  }
} // namespace whipple
