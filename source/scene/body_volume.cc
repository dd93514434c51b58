// SPDX-License-Identifier: LGPL-2.1-or-later
#include <whipple/scene/body_volume.h>

namespace whipple
{
  template <int dim>
  double
  body_volume(Symmetry symmetry, const Shape<dim> &shape, const Vector<dim> &lower, const Vector<dim> &upper)
  {
    return shape->volume(symmetry, lower, upper);
  }

  template double
  body_volume<2>(Symmetry, const Shape<2> &, const Vector<2> &, const Vector<2> &);
} // namespace whipple
