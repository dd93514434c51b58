// SPDX-License-Identifier: LGPL-2.1-or-later
#include <whipple/scene/box_shape.h>
#include <whipple/scene/shape_registry.h>
#include <whipple/scene/sphere_shape.h>

#include <algorithm>
#include <array>
#include <cmath>
#include <numbers>

namespace whipple
{
  namespace
  {
    /// Half the chord of a circle at a distance from its center; 0 outside.
    double
    half_chord(double radius, double distance)
    {
      return std::sqrt(std::max(0., (radius - distance) * (radius + distance)));
    }

    /// Volume of revolution of the part of r^2 + z^2 < R^2 in [r0, r1] x [z0, z1].
    double
    ball_volume(double radius, double r0, double r1, double z0, double z1)
    {
      if (r0 >= radius)
        return 0;
      const double a0    = half_chord(radius, r0); // |z| where the sphere crosses r0
      const double a1    = half_chord(radius, r1); // ... and r1: nearer to the equator the cell is full
      const auto   outer = [&](double from, double to) {
        const double p = std::max(z0, from), q = std::min(z1, to); // integral of a0^2 - z^2
        return p < q ? (q - p) * (a0 * a0 - (p * p + p * q + q * q) / 3.) : 0.;
      };
      const double p = std::max(z0, -a1), q = std::min(z1, a1);
      const double inner = p < q ? (q - p) * (r1 - r0) * (r1 + r0) : 0.;
      return std::numbers::pi * (outer(-a0, -a1) + inner + outer(a1, a0));
    }

    /// Area under the upper half circle y = sqrt(R^2 - x^2) from p to q: trapezoid below the chord and the
    /// circular segment above it (no difference of large antiderivatives).
    double
    area_under_arc(double radius, double p, double q)
    {
      const double yp = half_chord(radius, p), yq = half_chord(radius, q);
      const double chord = std::hypot(q - p, yq - yp);
      const double angle = 2. * std::asin(std::min(1., 0.5 * chord / radius));
      return 0.5 * (q - p) * (yp + yq) + 0.5 * radius * radius * (angle - std::sin(angle));
    }

    /// Area of the part of x^2 + y^2 < R^2 in a box.
    double
    disk_area(double radius, const Vector<2> &lower, const Vector<2> &upper)
    {
      // between the x where the circle crosses the box's y, its upper and lower bound are each one curve
      const double          c0 = half_chord(radius, lower[1]), c1 = half_chord(radius, upper[1]);
      std::array<double, 8> x{{lower[0], upper[0], -radius, radius, -c0, c0, -c1, c1}};
      for (double &break_point : x)
        break_point =
            std::clamp(break_point, std::max(lower[0], -radius), std::max(lower[0], std::min(upper[0], radius)));
      std::sort(x.begin(), x.end());
      double area = 0;
      for (std::size_t i = 0; i + 1 < x.size(); ++i)
        {
          const double p = x[i], q = x[i + 1], arc = half_chord(radius, 0.5 * (p + q));
          if (!(p < q) || std::min(upper[1], arc) <= std::max(lower[1], -arc))
            continue;
          area += arc < upper[1] ? area_under_arc(radius, p, q) : upper[1] * (q - p);
          area += -arc > lower[1] ? area_under_arc(radius, p, q) : -lower[1] * (q - p);
        }
      return area;
    }
  } // namespace

  template <int dim>
  Sphere<dim>::Sphere(const Vector<dim> &given_center, double given_diameter)
    : center(given_center)
    , diameter(given_diameter)
  {
  }

  template <int dim>
  Box<dim>
  Sphere<dim>::extent() const
  {
    Box<dim> box;
    for (int d = 0; d < dim; ++d)
      {
        box.lower[d] = center[d] - 0.5 * diameter;
        box.upper[d] = center[d] + 0.5 * diameter;
      }
    return box;
  }

  template <int dim>
  double
  Sphere<dim>::volume(Symmetry symmetry, const Vector<dim> &lower, const Vector<dim> &upper) const
  {
    const double radius = 0.5 * diameter;
    Vector<dim>  from, to;
    double       nearest = 0, farthest = 0; // squares of the distances of the box's points from the center
    for (int d = 0; d < dim; ++d)
      {
        from[d] = lower[d] - center[d];
        to[d]   = upper[d] - center[d];
        farthest += std::max(from[d] * from[d], to[d] * to[d]);
        const double near = std::max({0., from[d], -to[d]});
        nearest += near * near;
      }
    if (farthest <= radius * radius)
      return box_volume(symmetry, lower, upper);
    if (nearest >= radius * radius)
      return 0;
    return symmetry == Symmetry::planar ? disk_area(radius, from, to)
                                        : ball_volume(radius, from[0], to[0], from[1], to[1]);
  }

  template <int dim>
  bool
  Sphere<dim>::contains(const Vector<dim> &x) const
  {
    double square = 0;
    for (int d = 0; d < dim; ++d)
      square += (x[d] - center[d]) * (x[d] - center[d]);
    constexpr double round_off = 1e-12;
    return square <= (1. + round_off) * 0.25 * diameter * diameter;
  }

  template <int dim>
  std::vector<ConvexPart<dim>>
  Sphere<dim>::parts(const Box<dim> &) const
  {
    return {{{center}, 0.5 * diameter}};
  }

  template <int dim>
  double
  Sphere<dim>::least_thickness(std::span<const MirrorPlane>) const
  {
    return diameter;
  }

  template <int dim>
  bool
  Sphere<dim>::is_mirrored() const
  {
    return center[0] == 0;
  }

  template <int dim>
  Shape<dim>
  Sphere<dim>::turned(const Turn<dim> &turn, const Box<dim> &) const
  {
    return Sphere(turn(center), diameter);
  }

  template class Sphere<2>;

  namespace
  {
    const ShapeRegistration<2> registration(
        {.name          = "sphere",
         .summary       = "a ball; planar: the cylinder whose cross-section it is",
         .documentation = "In axisymmetry it sits on the axis.",
         .parameters    = {{"Center", "two lengths", "", "its middle"}, {"Diameter", "a length", "", "of the ball"}},
         .position_key  = "Center",
         .size_key      = "Diameter"},
        [](const ShapeInput<2> &input) -> Shape<2> {
          const Vector<2> center = input.point("Center");
          if (input.symmetry() == Symmetry::axisymmetric && center[0] != 0)
            input.reject("Center", "in axisymmetry a sphere sits on the axis; its first component must be 0 cm");
          return Sphere<2>(center, input.positive_length("Diameter"));
        });
  } // namespace
} // namespace whipple
