// SPDX-License-Identifier: LGPL-2.1-or-later
#include <whipple/scene/box_shape.h>
#include <whipple/scene/plate_shape.h>
#include <whipple/scene/polygon_shape.h>
#include <whipple/scene/shape_registry.h>

#include <algorithm>
#include <cmath>
#include <optional>

namespace whipple
{
  template <int dim>
  Plate<dim>::Plate(double given_front, double given_thickness, double given_half_width)
    : front(given_front)
    , thickness(given_thickness)
    , half_width(given_half_width)
  {
  }

  template <int dim>
  Box<dim>
  Plate<dim>::extent() const
  {
    Box<dim> box;
    box.lower.fill(-half_width);
    box.upper.fill(half_width);
    box.lower[flight_axis<dim>] = front;
    box.upper[flight_axis<dim>] = front + thickness;
    return box;
  }

  template <int dim>
  double
  Plate<dim>::volume(Symmetry symmetry, const Vector<dim> &lower, const Vector<dim> &upper) const
  {
    return BoxShape<dim>(extent()).volume(symmetry, lower, upper);
  }

  template <int dim>
  bool
  Plate<dim>::contains(const Vector<dim> &x) const
  {
    constexpr double round_off = 1e-12;
    const double     depth     = x[flight_axis<dim>] - front;
    return depth >= -round_off * thickness && depth <= (1. + round_off) * thickness &&
           std::abs(x[0]) <= (1. + round_off) * half_width;
  }

  template <int dim>
  std::vector<ConvexPart<dim>>
  Plate<dim>::parts(const Box<dim> &window) const
  {
    Box<dim> box = extent();
    if (std::isinf(half_width))
      {
        box.lower[0] = window.lower[0];
        box.upper[0] = window.upper[0];
      }
    return {{box_corners(box)}};
  }

  template <int dim>
  double
  Plate<dim>::least_thickness(std::span<const MirrorPlane> mirrors) const
  {
    return BoxShape<dim>(extent()).least_thickness(mirrors);
  }

  template <int dim>
  bool
  Plate<dim>::is_mirrored() const
  {
    return true;
  }

  template <int dim>
  bool
  Plate<dim>::is_box() const
  {
    return true;
  }

  template <int dim>
  Shape<dim>
  Plate<dim>::turned(const Turn<dim> &turn, const Box<dim> &domain) const
  {
    const Vector<dim> zero{}, moved = turn(zero);
    if (const Vector<dim> along = turn({{1., 0.}}); along[1] == moved[1] && (std::isinf(half_width) || moved[0] == 0))
      return Plate(std::min(turn({{0., front}})[1], turn({{0., front + thickness}})[1]), thickness, half_width);
    // an infinite plate is turned as one that reaches out of the domain on both sides wherever it comes to lie
    double reach = 0;
    for (int d = 0; d < dim; ++d)
      reach += 2. * (std::abs(domain.lower[d]) + std::abs(domain.upper[d]) + std::abs(moved[d]));
    const bool               infinite = std::isinf(half_width);
    std::vector<Vector<dim>> corners  = box_corners(Plate(front, thickness, infinite ? reach : half_width).extent());
    for (Vector<dim> &x : corners)
      x = turn(x);
    if (infinite)
      return PolygonShape(std::move(corners), domain);
    return turned_box(std::move(corners));
  }

  template class Plate<2>;

  namespace
  {
    const ShapeRegistration<2>
        registration({.name          = "plate",
                      .summary       = "a flat plate normal to axis 1, around axis 0 = 0",
                      .documentation = "Its hole is measured (doc/summary.md), unless it is turned out of that plane.",
                      .parameters    = {{"Front face", "a length", "", "its lower face along axis 1"},
                                        {"Thickness", "a length", "", "how far it reaches above that"},
                                        {"Half width", "a length", "the whole domain", "it reaches to this \\|x\\| or r"}},
                      .position_key  = "Front face",
                      .size_key      = "Thickness"},
                     [](const ShapeInput<2> &input) -> Shape<2> {
                       Plate<2> plate(input.length("Front face"), input.positive_length("Thickness"));
                       if (input.given("Half width"))
                         plate.half_width = input.positive_length("Half width");
                       return plate;
                     });
  } // namespace
} // namespace whipple
