// SPDX-License-Identifier: LGPL-2.1-or-later
#pragma once

#include <whipple/scene/shape.h>

namespace whipple
{
  /// A ball; in planar symmetry the cylinder whose cross-section it is. In axisymmetry its center is on the axis.
  template <int dim>
  class Sphere : public ShapeGeometry<dim>
  {
  public:
    /// Lengths in cm.
    Sphere(const Vector<dim> &center, double diameter);

    Box<dim>
    extent() const override;
    double
    volume(Symmetry symmetry, const Vector<dim> &lower, const Vector<dim> &upper) const override;
    bool
    contains(const Vector<dim> &x) const override;
    std::vector<ConvexPart<dim>>
    parts(const Box<dim> &window) const override;
    double
    least_thickness(std::span<const MirrorPlane> mirrors) const override;
    bool
    is_mirrored() const override;
    Shape<dim>
    turned(const Turn<dim> &turn, const Box<dim> &domain) const override;

    Vector<dim> center;   ///< cm
    double      diameter; ///< cm
  };
} // namespace whipple
