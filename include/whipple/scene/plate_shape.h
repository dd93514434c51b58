// SPDX-License-Identifier: LGPL-2.1-or-later
#pragma once

#include <whipple/scene/shape.h>

#include <limits>

namespace whipple
{
  /// A flat plate normal to the line of flight, around axis 0 = 0.
  template <int dim>
  class Plate : public ShapeGeometry<dim>
  {
  public:
    /// Lengths in cm. An infinite half width is the whole domain.
    Plate(double front, double thickness, double half_width = std::numeric_limits<double>::infinity());

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
    bool
    is_box() const override;
    Shape<dim>
    turned(const Turn<dim> &turn, const Box<dim> &domain) const override;

    double front;      ///< lower face along the line of flight, cm
    double thickness;  ///< cm
    double half_width; ///< |x| or r below it, cm
  };
} // namespace whipple
