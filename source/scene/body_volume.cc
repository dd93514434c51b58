// SPDX-License-Identifier: LGPL-2.1-or-later
#include <whipple/mesh/geometry.h>
#include <whipple/scene/body_volume.h>

#include <algorithm>
#include <cmath>
#include <numbers>

namespace whipple
{
  namespace
  {
    double
    box_volume(Symmetry symmetry, const Vector<2> &lower, const Vector<2> &upper)
    {
      const geometry::Quad quad{
          {{{lower[0], upper[0], lower[0], upper[0]}}, {{lower[1], lower[1], upper[1], upper[1]}}}};
      return symmetry == Symmetry::planar ? geometry::volume<Symmetry::planar>(quad)
                                          : geometry::volume<Symmetry::axisymmetric>(quad);
    }

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

    double
    shape_volume(Symmetry symmetry, const Box<2> &box, const Vector<2> &lower, const Vector<2> &upper)
    {
      Vector<2> from, to;
      for (int d = 0; d < 2; ++d)
        {
          from[d] = std::max(lower[d], box.lower[d]);
          to[d]   = std::min(upper[d], box.upper[d]);
          if (!(from[d] < to[d]))
            return 0;
        }
      return box_volume(symmetry, from, to);
    }

    double
    shape_volume(Symmetry symmetry, const Plate<2> &plate, const Vector<2> &lower, const Vector<2> &upper)
    {
      return shape_volume(symmetry, extent<2>(plate), lower, upper);
    }

    double
    shape_volume(Symmetry symmetry, const Sphere<2> &sphere, const Vector<2> &lower, const Vector<2> &upper)
    {
      const double radius = 0.5 * sphere.diameter;
      Vector<2>    from, to;
      double       nearest = 0, farthest = 0; // squares of the distances of the box's points from the center
      for (int d = 0; d < 2; ++d)
        {
          from[d] = lower[d] - sphere.center[d];
          to[d]   = upper[d] - sphere.center[d];
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
  } // namespace

  template <int dim>
  double
  body_volume(Symmetry symmetry, const Shape<dim> &shape, const Vector<dim> &lower, const Vector<dim> &upper)
  {
    return std::visit([&](const auto &s) { return shape_volume(symmetry, s, lower, upper); }, shape);
  }

  template double
  body_volume<2>(Symmetry, const Shape<2> &, const Vector<2> &, const Vector<2> &);
} // namespace whipple
