// SPDX-License-Identifier: LGPL-2.1-or-later
#include <whipple/mesh/cell_geometry.h>
#include <whipple/scene/box_shape.h>
#include <whipple/scene/polygon_shape.h>
#include <whipple/scene/shape_registry.h>

#include <algorithm>
#include <cmath>
#include <limits>

namespace whipple
{
  double
  box_volume(Symmetry symmetry, const Vector<2> &lower, const Vector<2> &upper)
  {
    return cell_volume(symmetry, CellShape<2>::box(lower, upper));
  }

  std::vector<Vector<2>>
  box_corners(const Box<2> &box)
  {
    return {box.lower, {{box.upper[0], box.lower[1]}}, box.upper, {{box.lower[0], box.upper[1]}}};
  }

  Shape<2>
  turned_box(std::vector<Vector<2>> corners)
  {
    Box<2> box{corners[0], corners[0]};
    for (const Vector<2> &x : corners)
      for (int d = 0; d < 2; ++d)
        {
          box.lower[d] = std::min(box.lower[d], x[d]);
          box.upper[d] = std::max(box.upper[d], x[d]);
        }
    for (const Vector<2> &x : corners)
      for (int d = 0; d < 2; ++d)
        if (x[d] != box.lower[d] && x[d] != box.upper[d])
          return PolygonShape(std::move(corners));
    return BoxShape<2>(box);
  }

  template <int dim>
  BoxShape<dim>::BoxShape(const Box<dim> &box)
    : box_(box)
  {
  }

  template <int dim>
  Box<dim>
  BoxShape<dim>::extent() const
  {
    return box_;
  }

  template <int dim>
  double
  BoxShape<dim>::volume(Symmetry symmetry, const Vector<dim> &lower, const Vector<dim> &upper) const
  {
    Vector<dim> from, to;
    for (int d = 0; d < dim; ++d)
      {
        from[d] = std::max(lower[d], box_.lower[d]);
        to[d]   = std::min(upper[d], box_.upper[d]);
        if (!(from[d] < to[d]))
          return 0;
      }
    return box_volume(symmetry, from, to);
  }

  template <int dim>
  bool
  BoxShape<dim>::contains(const Vector<dim> &x) const
  {
    constexpr double round_off = 1e-12;
    for (int d = 0; d < dim; ++d)
      {
        const double slack = round_off * (box_.upper[d] - box_.lower[d]);
        if (!(x[d] >= box_.lower[d] - slack && x[d] <= box_.upper[d] + slack))
          return false;
      }
    return true;
  }

  template <int dim>
  std::vector<ConvexPart<dim>>
  BoxShape<dim>::parts(const Box<dim> &) const
  {
    return {{box_corners(box_)}};
  }

  template <int dim>
  double
  BoxShape<dim>::least_thickness(std::span<const MirrorPlane> mirrors) const
  {
    double least = std::numeric_limits<double>::infinity();
    for (int d = 0; d < dim; ++d)
      {
        const double length  = box_.upper[d] - box_.lower[d];
        const bool   touches = std::any_of(mirrors.begin(), mirrors.end(), [&](const MirrorPlane &mirror) {
          return mirror.axis == d && (mirror.place == box_.lower[d] || mirror.place == box_.upper[d]);
        });
        least                = std::min(least, touches ? 2. * length : length);
      }
    return least;
  }

  template <int dim>
  bool
  BoxShape<dim>::is_mirrored() const
  {
    return box_.lower[0] == -box_.upper[0];
  }

  template <int dim>
  bool
  BoxShape<dim>::is_box() const
  {
    return true;
  }

  template <int dim>
  Shape<dim>
  BoxShape<dim>::turned(const Turn<dim> &turn, const Box<dim> &) const
  {
    std::vector<Vector<dim>> corners = box_corners(box_);
    for (Vector<dim> &x : corners)
      x = turn(x);
    return turned_box(std::move(corners));
  }

  template class BoxShape<2>;

  namespace
  {
    const ShapeRegistration<2>
        registration({.name              = "box",
                      .summary           = "an axis-aligned box; axisymmetric: a cylinder or ring",
                      .documentation     = "",
                      .parameters        = {{"Lower corner", "two lengths", "", "its least coordinates"},
                                            {"Upper corner", "two lengths", "", "its largest coordinates"}},
                      .position_key      = "Lower corner",
                      .size_key          = "Upper corner",
                      .placed_by_one_key = false},
                     [](const ShapeInput<2> &input) -> Shape<2> {
                       const Box<2> box{input.point("Lower corner"), input.point("Upper corner")};
                       for (int d = 0; d < 2; ++d)
                         if (!(box.upper[d] > box.lower[d]))
                           input.reject("Upper corner", "must lie above the lower corner '" +
                                                            input.text("Lower corner") + "' along every axis");
                       return BoxShape<2>(box);
                     });
  } // namespace
} // namespace whipple
