// SPDX-License-Identifier: LGPL-2.1-or-later
#pragma once

#include <whipple/scene/shape.h>

namespace whipple
{
  /// An axis-aligned box; in axisymmetry a (hollow) cylinder.
  template <int dim>
  class BoxShape : public ShapeGeometry<dim>
  {
  public:
    explicit BoxShape(const Box<dim> &box);

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

  private:
    Box<dim> box_;
  };

  /// Volume of a box: its area times 1 cm, or its volume of revolution, cm^3.
  double
  box_volume(Symmetry symmetry, const Vector<2> &lower, const Vector<2> &upper);

  /// A shape with four corners that once were those of a box: still a box if the corners lie on its edges exactly.
  Shape<2>
  turned_box(std::vector<Vector<2>> corners);

  /// Corners of a box, counter-clockwise.
  std::vector<Vector<2>>
  box_corners(const Box<2> &box);
} // namespace whipple
