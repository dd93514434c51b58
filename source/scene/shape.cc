// SPDX-License-Identifier: LGPL-2.1-or-later
#include <whipple/scene/box_shape.h>
#include <whipple/scene/shape.h>

#include <algorithm>
#include <array>
#include <cmath>
#include <limits>
#include <numbers>

namespace whipple
{
  namespace
  {
    /// Depth to which shapes may overlap and still count as touching, relative to their size, and round-off of corners
    /// relative to where they are.
    constexpr double touching = 1e-12, round_off = 4e-15;

    /// Range of a part's corners along a direction.
    std::array<double, 2>
    projected(const ConvexPart<2> &part, const Vector<2> &direction)
    {
      std::array<double, 2> range{{std::numeric_limits<double>::infinity(), -std::numeric_limits<double>::infinity()}};
      for (const Vector<2> &x : part.corner)
        {
          const double at = x[0] * direction[0] + x[1] * direction[1];
          range           = {{std::min(range[0], at), std::max(range[1], at)}};
        }
      return range;
    }

    /// Whether a normal of an edge of `a` separates the hulls of two parts, or lets them share no more than `slack`.
    bool
    edge_separates(const ConvexPart<2> &a, const ConvexPart<2> &b, double slack)
    {
      const std::size_t n = a.corner.size();
      for (std::size_t i = 0; i < n && n > 1; ++i)
        {
          const Vector<2> &p = a.corner[i], &q = a.corner[(i + 1) % n];
          const double     length = std::hypot(q[0] - p[0], q[1] - p[1]);
          const Vector<2>  normal{{(q[1] - p[1]) / length, (p[0] - q[0]) / length}};
          const auto       of_a = projected(a, normal), of_b = projected(b, normal);
          if (of_a[1] - of_b[0] <= slack || of_b[1] - of_a[0] <= slack)
            return true;
        }
      return false;
    }

    double
    distance_to_edge(const Vector<2> &x, const Vector<2> &p, const Vector<2> &q)
    {
      const double dx = q[0] - p[0], dy = q[1] - p[1], square = dx * dx + dy * dy;
      const double s = square > 0 ? std::clamp(((x[0] - p[0]) * dx + (x[1] - p[1]) * dy) / square, 0., 1.) : 0.;
      return std::hypot(x[0] - p[0] - s * dx, x[1] - p[1] - s * dy);
    }

    /// Least distance of the corners of `a` from the edges of `b`.
    double
    corner_distance(const ConvexPart<2> &a, const ConvexPart<2> &b)
    {
      double least = std::numeric_limits<double>::infinity();
      for (const Vector<2> &x : a.corner)
        for (std::size_t i = 0; i < b.corner.size(); ++i)
          least = std::min(least, distance_to_edge(x, b.corner[i], b.corner[(i + 1) % b.corner.size()]));
      return least;
    }

    bool
    share(const ConvexPart<2> &a, const ConvexPart<2> &b, double slack)
    {
      const double radius = a.radius + b.radius;
      const bool   points = a.corner.size() == 1 && b.corner.size() == 1;
      if (!points && !edge_separates(a, b, slack) && !edge_separates(b, a, slack))
        return true;
      return radius > 0 && std::min(corner_distance(a, b), corner_distance(b, a)) < radius - slack;
    }

    /// Box around a convex part.
    Box<2>
    bounding_box(const ConvexPart<2> &part)
    {
      Box<2> box;
      for (int d = 0; d < 2; ++d)
        {
          const auto [low, high] = std::minmax_element(part.corner.begin(), part.corner.end(),
                                                       [d](const auto &x, const auto &y) { return x[d] < y[d]; });
          box.lower[d]           = (*low)[d] - part.radius;
          box.upper[d]           = (*high)[d] + part.radius;
        }
      return box;
    }

    bool
    apart(const Box<2> &a, const Box<2> &b)
    {
      return a.upper[0] < b.lower[0] || b.upper[0] < a.lower[0] || a.upper[1] < b.lower[1] || b.upper[1] < a.lower[1];
    }

    /// A box that holds all that is finite of two others; where both are infinite, any part of them.
    Box<2>
    finite_window(const Box<2> &a, const Box<2> &b)
    {
      Box<2> window;
      for (int d = 0; d < 2; ++d)
        {
          double low = std::numeric_limits<double>::infinity(), high = -low;
          for (const double x : {a.lower[d], a.upper[d], b.lower[d], b.upper[d]})
            if (std::isfinite(x))
              {
                low  = std::min(low, x);
                high = std::max(high, x);
              }
          window.lower[d] = low <= high ? low : -1.;
          window.upper[d] = low < high ? high : window.lower[d] + 1.;
        }
      return window;
    }
  } // namespace

  template <int dim>
  Shape<dim>::Shape(const Box<dim> &box)
    : Shape(BoxShape<dim>(box))
  {
  }

  template <int dim>
  bool
  overlap(const Shape<dim> &a, const Shape<dim> &b)
  {
    const Box<dim> box_a = extent(a), box_b = extent(b), window = finite_window(box_a, box_b);
    double         size = std::numeric_limits<double>::infinity(), far = 0;
    for (int d = 0; d < dim; ++d)
      {
        size = std::min({size, box_a.upper[d] - box_a.lower[d], box_b.upper[d] - box_b.lower[d]});
        far  = std::max({far, std::abs(window.lower[d]), std::abs(window.upper[d])});
      }
    const double slack   = touching * size + round_off * far;
    const auto   parts_b = b->parts(window);
    for (const ConvexPart<dim> &part_a : a->parts(window))
      {
        const Box<2> around = bounding_box(part_a);
        for (const ConvexPart<dim> &part_b : parts_b)
          if (!apart(around, bounding_box(part_b)) && share(part_a, part_b, slack))
            return true;
      }
    return false;
  }

  template <>
  Turn<2>
  Turn<2>::in_plane(double degrees, const Vector<2> &center)
  {
    double quarter = std::fmod(degrees, 360.) / 90.;
    quarter += quarter < 0 ? 4. : 0.;
    Vector<2> first{{std::cos(0.5 * std::numbers::pi * quarter), std::sin(0.5 * std::numbers::pi * quarter)}};
    if (quarter == std::floor(quarter)) // without round-off
      first = {{quarter == 0. || quarter == 4. ? 1. : (quarter == 2. ? -1. : 0.),
                quarter == 1. ? 1. : (quarter == 3. ? -1. : 0.)}};
    Turn turn;
    turn.center_   = center;
    turn.image_[0] = first;
    turn.image_[1] = {{-first[1], first[0]}};
    return turn;
  }

  template <>
  Turn<2>
  Turn<2>::end_for_end(const Vector<2> &center)
  {
    Turn turn;
    turn.center_   = center;
    turn.image_[0] = {{1., 0.}};
    turn.image_[1] = {{0., -1.}};
    return turn;
  }

  template <>
  Vector<2>
  Turn<2>::operator()(const Vector<2> &x) const
  {
    const double a = x[0] - center_[0], b = x[1] - center_[1];
    return {{center_[0] + (a * image_[0][0] + b * image_[1][0]), center_[1] + (a * image_[0][1] + b * image_[1][1])}};
  }

  template class Turn<2>;
  template class Shape<2>;
  template bool
  overlap(const Shape<2> &, const Shape<2> &);
} // namespace whipple
