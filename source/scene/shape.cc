// SPDX-License-Identifier: LGPL-2.1-or-later
#include <whipple/scene/shape.h>

#include <algorithm>
#include <cmath>

namespace whipple
{
  namespace
  {
    /// Depth to which shapes may overlap and still count as touching, relative to their size.
    constexpr double touching = 1e-12;

    template <int dim>
    Box<dim>
    extent_of(const Sphere<dim> &sphere)
    {
      Box<dim> box;
      for (int d = 0; d < dim; ++d)
        {
          box.lower[d] = sphere.center[d] - 0.5 * sphere.diameter;
          box.upper[d] = sphere.center[d] + 0.5 * sphere.diameter;
        }
      return box;
    }

    template <int dim>
    Box<dim>
    extent_of(const Plate<dim> &plate)
    {
      Box<dim> box;
      box.lower.fill(-plate.half_width);
      box.upper.fill(plate.half_width);
      box.lower[1] = plate.front;
      box.upper[1] = plate.front + plate.thickness;
      return box;
    }

    template <int dim>
    Box<dim>
    extent_of(const Box<dim> &box)
    {
      return box;
    }

    template <int dim>
    bool
    share(const Sphere<dim> &a, const Sphere<dim> &b)
    {
      double square = 0;
      for (int d = 0; d < dim; ++d)
        square += (a.center[d] - b.center[d]) * (a.center[d] - b.center[d]);
      return std::sqrt(square) < 0.5 * (a.diameter + b.diameter) * (1. - touching);
    }

    /// A sphere reaches into a box if the box's nearest point lies inside it.
    template <int dim>
    bool
    share(const Sphere<dim> &sphere, const Box<dim> &box)
    {
      double square = 0;
      for (int d = 0; d < dim; ++d)
        {
          const double distance = sphere.center[d] - std::clamp(sphere.center[d], box.lower[d], box.upper[d]);
          square += distance * distance;
        }
      return std::sqrt(square) < 0.5 * sphere.diameter * (1. - touching);
    }

    template <int dim>
    bool
    share(const Box<dim> &a, const Box<dim> &b)
    {
      for (int d = 0; d < dim; ++d)
        {
          const double common = std::min(a.upper[d], b.upper[d]) - std::max(a.lower[d], b.lower[d]);
          const double size   = std::min(a.upper[d] - a.lower[d], b.upper[d] - b.lower[d]);
          if (common <= (std::isfinite(size) ? touching * size : 0.))
            return false;
        }
      return true;
    }
  } // namespace

  template <int dim>
  Box<dim>
  extent(const Shape<dim> &shape)
  {
    return std::visit([](const auto &s) { return extent_of(s); }, shape);
  }

  template <int dim>
  bool
  overlap(const Shape<dim> &a, const Shape<dim> &b)
  {
    const auto *sphere_a = std::get_if<Sphere<dim>>(&a), *sphere_b = std::get_if<Sphere<dim>>(&b);
    if (sphere_a && sphere_b)
      return share(*sphere_a, *sphere_b);
    if (sphere_a)
      return share(*sphere_a, extent(b));
    if (sphere_b)
      return share(*sphere_b, extent(a));
    return share(extent(a), extent(b));
  }

  template Box<2>
  extent(const Shape<2> &);
  template bool
  overlap(const Shape<2> &, const Shape<2> &);
} // namespace whipple
