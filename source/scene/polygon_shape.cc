// SPDX-License-Identifier: LGPL-2.1-or-later
#include <whipple/scene/box_shape.h>
#include <whipple/scene/polygon_shape.h>
#include <whipple/scene/triangulation.h>

#include <algorithm>
#include <cmath>
#include <limits>

namespace whipple
{
  namespace
  {
    constexpr double infinity = std::numeric_limits<double>::infinity();

    /// Round-off of corners, relative to the size of the polygon.
    constexpr double round_off = 1e-12;

    /// Part of a box that sums over pieces of it may miss.
    constexpr double full = 1e-13;

    /// Box around points; lower above upper if there are none.
    template <typename Points, typename Position>
    Box<2>
    box_around(const Points &points, const Position &position)
    {
      Box<2> box{{{infinity, infinity}}, {{-infinity, -infinity}}};
      for (const auto &point : points)
        for (int d = 0; d < 2; ++d)
          {
            box.lower[d] = std::min(box.lower[d], position(point)[d]);
            box.upper[d] = std::max(box.upper[d], position(point)[d]);
          }
      return box;
    }

    Box<2>
    box_around(const std::vector<Vector<2>> &points)
    {
      return box_around(points, [](const Vector<2> &x) -> const Vector<2> & { return x; });
    }

    double
    size_of(const Box<2> &box)
    {
      return std::max(box.upper[0] - box.lower[0], box.upper[1] - box.lower[1]);
    }

    /// Whether point x, known to lie on the line through a and b, lies between them.
    bool
    between(const Vector<2> &x, const Vector<2> &a, const Vector<2> &b)
    {
      for (int d = 0; d < 2; ++d)
        if (x[d] < std::min(a[d], b[d]) || x[d] > std::max(a[d], b[d]))
          return false;
      return true;
    }

    /// Whether two closed edges have a point in common.
    bool
    edges_meet(const Vector<2> &a, const Vector<2> &b, const Vector<2> &c, const Vector<2> &d)
    {
      const double of_c = turn_area(a, b, c), of_d = turn_area(a, b, d);
      const double of_a = turn_area(c, d, a), of_b = turn_area(c, d, b);
      if (((of_c > 0 && of_d < 0) || (of_c < 0 && of_d > 0)) && ((of_a > 0 && of_b < 0) || (of_a < 0 && of_b > 0)))
        return true;
      return (of_c == 0 && between(c, a, b)) || (of_d == 0 && between(d, a, b)) || (of_a == 0 && between(a, c, d)) ||
             (of_b == 0 && between(b, c, d));
    }

    /// Whether an edge that goes on from b to c comes back over the one from a to b.
    bool
    folds_back(const Vector<2> &a, const Vector<2> &b, const Vector<2> &c)
    {
      return turn_area(a, b, c) == 0 && (b[0] - a[0]) * (c[0] - b[0]) + (b[1] - a[1]) * (c[1] - b[1]) < 0;
    }

    /// The part of a triangle in a box, empty if they are apart.
    projection::Polygon
    clipped(const projection::Triangle &triangle, const Box<2> &box, const Vector<2> &lower, const Vector<2> &upper)
    {
      for (int d = 0; d < 2; ++d)
        if (!(box.lower[d] < upper[d] && box.upper[d] > lower[d]))
          return {};
      return projection::clip(triangle, lower, upper);
    }
  } // namespace

  std::string
  outline_problem(const std::vector<Vector<2>> &corners)
  {
    const std::size_t n    = corners.size();
    const auto        edge = [](std::size_t i) { return std::to_string(i + 1); };
    if (n < 3)
      return "a polygon has at least 3 corners";
    const auto at = [&](std::size_t i) -> const Vector<2> & { return corners[i % n]; };
    for (std::size_t i = 0; i < n; ++i)
      if (at(i) == at(i + 1))
        return "corners " + edge(i) + " and " + edge((i + 1) % n) + " are the same";
    for (std::size_t i = 0; i < n; ++i)
      if (folds_back(at(i), at(i + 1), at(i + 2)))
        return "edge " + edge((i + 1) % n) + " comes back over edge " + edge(i);
    for (std::size_t i = 0; i < n; ++i)
      for (std::size_t k = i + 2; k < n; ++k)
        if ((k + 1) % n != i && edges_meet(at(i), at(i + 1), at(k), at(k + 1)))
          return "edges " + edge(i) + " and " + edge(k) + " cross or touch";
    const double size = size_of(box_around(corners));
    return std::abs(outline_area(corners)) > round_off * size * size ? "" : "the corners enclose no area";
  }

  PolygonShape::PolygonShape(std::vector<Vector<2>> corners, const std::optional<Box<2>> &within)
    : corners_(std::move(corners))
    , within_(within)
    , extent_(box_around(corners_))
  {
    if (outline_area(corners_) < 0)
      std::reverse(corners_.begin(), corners_.end());
    for (const std::array<Vector<2>, 3> &x : triangulate(corners_))
      pieces_.push_back(
          {{{{x[0], {}}, {x[1], {}}, {x[2], {}}}}, box_around(std::vector<Vector<2>>(x.begin(), x.end()))});
    if (!within)
      return;
    std::vector<Vector<2>> inside;
    for (const Piece &piece : pieces_)
      {
        const projection::Polygon part = clipped(piece.triangle, piece.box, within->lower, within->upper);
        for (int i = 0; i < part.size; ++i)
          inside.push_back(part.vertex[i].x);
      }
    if (!inside.empty())
      extent_ = box_around(inside);
  }

  Box<2>
  PolygonShape::extent() const
  {
    return extent_;
  }

  double
  PolygonShape::volume(Symmetry symmetry, const Vector<2> &lower, const Vector<2> &upper) const
  {
    double volume = 0;
    for (const Piece &piece : pieces_)
      if (const projection::Polygon part = clipped(piece.triangle, piece.box, lower, upper); part.size > 0)
        volume += projection::moments(symmetry, part).volume;
    // a box that lies inside is full to the last bit
    const double whole = box_volume(symmetry, lower, upper);
    return std::abs(volume - whole) <= full * whole ? whole : volume;
  }

  bool
  PolygonShape::contains(const Vector<2> &x) const
  {
    const double slack = round_off * size_of(extent_);
    for (const auto &[triangle, box] : pieces_)
      {
        if (x[0] < box.lower[0] - slack || x[0] > box.upper[0] + slack || x[1] < box.lower[1] - slack ||
            x[1] > box.upper[1] + slack)
          continue;
        bool inside = true;
        for (int i = 0; i < 3 && inside; ++i)
          {
            const Vector<2> &a = triangle[i].x, &b = triangle[(i + 1) % 3].x;
            inside = turn_area(a, b, x) >= -slack * std::hypot(b[0] - a[0], b[1] - a[1]);
          }
        if (inside)
          return true;
      }
    return false;
  }

  std::vector<ConvexPart<2>>
  PolygonShape::parts(const Box<2> &) const
  {
    std::vector<ConvexPart<2>> all;
    for (const Piece &piece : pieces_)
      all.push_back({{piece.triangle[0].x, piece.triangle[1].x, piece.triangle[2].x}});
    return all;
  }

  namespace
  {
    bool
    lies_on(const Vector<2> &a, const Vector<2> &b, std::span<const MirrorPlane> mirrors, double slack)
    {
      return std::any_of(mirrors.begin(), mirrors.end(), [&](const MirrorPlane &mirror) {
        return std::abs(a[mirror.axis] - mirror.place) <= slack && std::abs(b[mirror.axis] - mirror.place) <= slack;
      });
    }

    bool
    outside(const Vector<2> &x, const Box<2> &box)
    {
      return x[0] < box.lower[0] || x[0] > box.upper[0] || x[1] < box.lower[1] || x[1] > box.upper[1];
    }
  } // namespace

  double
  PolygonShape::least_thickness(std::span<const MirrorPlane> mirrors) const
  {
    const std::size_t n     = corners_.size();
    const double      slack = round_off * size_of(extent_);
    double            least = infinity;
    for (std::size_t i = 0; i < n; ++i)
      {
        const Vector<2> &a = corners_[i], &b = corners_[(i + 1) % n];
        const double     length = std::hypot(b[0] - a[0], b[1] - a[1]);
        const Vector<2>  middle{{0.5 * (a[0] + b[0]), 0.5 * (a[1] + b[1])}};
        const Vector<2>  inwards{{(a[1] - b[1]) / length, (b[0] - a[0]) / length}};
        // an edge on a mirror is none, and one that only closes what goes on outside neither
        if (lies_on(a, b, mirrors, slack) ||
            (within_ && outside(a, *within_) && outside(b, *within_) && outside(middle, *within_)))
          continue;
        double way = infinity;
        for (std::size_t k = 0; k < n; ++k)
          {
            const Vector<2> &c = corners_[k], &d = corners_[(k + 1) % n];
            const double     across = inwards[0] * (d[1] - c[1]) - inwards[1] * (d[0] - c[0]);
            if (k == i || across == 0)
              continue;
            const double t = ((c[0] - middle[0]) * (d[1] - c[1]) - (c[1] - middle[1]) * (d[0] - c[0])) / across;
            const double s = ((c[0] - middle[0]) * inwards[1] - (c[1] - middle[1]) * inwards[0]) / across;
            if (t > slack && s >= 0 && s <= 1)
              way = std::min(way, lies_on(c, d, mirrors, slack) ? 2. * t : t);
          }
        least = std::min(least, way);
      }
    return least;
  }

  bool
  PolygonShape::is_mirrored() const
  {
    const std::size_t n     = corners_.size();
    const double      slack = round_off * size_of(extent_);
    const auto        fits  = [&](std::size_t shift) {
      for (std::size_t i = 0; i < n; ++i)
        {
          const Vector<2> &x = corners_[i], &image = corners_[(shift + n - i) % n];
          if (std::abs(x[0] + image[0]) > slack || std::abs(x[1] - image[1]) > slack)
            return false;
        }
      return true;
    };
    for (std::size_t shift = 0; shift < n; ++shift)
      if (fits(shift))
        return true;
    return false;
  }

  Shape<2>
  PolygonShape::turned(const Turn<2> &turn, const Box<2> &) const
  {
    std::vector<Vector<2>> corners = corners_;
    for (Vector<2> &x : corners)
      x = turn(x);
    return PolygonShape(std::move(corners), within_);
  }
} // namespace whipple
