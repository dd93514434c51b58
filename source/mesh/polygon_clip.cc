// SPDX-License-Identifier: LGPL-2.1-or-later
#include <whipple/mesh/polygon_clip.h>

#include <algorithm>
#include <numbers>
#include <utility>

namespace whipple::projection
{
  namespace
  {
    /// Cut by sign * x[axis] <= sign * bound (Sutherland and Hodgman).
    void
    cut(Polygon &polygon, int axis, double sign, double bound)
    {
      Polygon    result;
      const auto depth = [&](const Vertex &v) { return sign * (bound - v.x[axis]); };
      for (int i = 0; i < polygon.size; ++i)
        {
          const Vertex &a = polygon.vertex[i], &b = polygon.vertex[(i + 1) % polygon.size];
          const double  inside_a = depth(a), inside_b = depth(b);
          if (inside_a >= 0)
            result.vertex[result.size++] = a;
          if ((inside_a > 0 && inside_b < 0) || (inside_a < 0 && inside_b > 0))
            {
              const double t = inside_a / (inside_a - inside_b);
              Vertex       v;
              for (int d = 0; d < 2; ++d)
                {
                  v.x[d] = a.x[d] + t * (b.x[d] - a.x[d]);
                  v.u[d] = a.u[d] + t * (b.u[d] - a.u[d]);
                }
              v.x[axis]                    = bound;
              result.vertex[result.size++] = v;
            }
        }
      polygon = result;
    }

    double
    double_area(const Vector<2> &a, const Vector<2> &b, const Vector<2> &c)
    {
      return (b[0] - a[0]) * (c[1] - a[1]) - (b[1] - a[1]) * (c[0] - a[0]);
    }

    /// Values of a linear function at the corners of a triangle.
    using Corners = std::array<double, 3>;

    double
    sum(const Corners &a)
    {
      return a[0] + a[1] + a[2];
    }

    double
    dot(const Corners &a, const Corners &b)
    {
      return a[0] * b[0] + a[1] * b[1] + a[2] * b[2];
    }

    /// Means over a triangle of products of linear functions: int L1^i L2^j L3^k dA = 2 A i! j! k! / (i+j+k+2)!.
    double
    mean_product(const Corners &a, const Corners &b)
    {
      return (sum(a) * sum(b) + dot(a, b)) / 12.;
    }

    double
    mean_product(const Corners &a, const Corners &b, const Corners &c)
    {
      const double diagonal = a[0] * b[0] * c[0] + a[1] * b[1] * c[1] + a[2] * b[2] * c[2];
      return (sum(a) * sum(b) * sum(c) + dot(a, b) * sum(c) + dot(a, c) * sum(b) + dot(b, c) * sum(a) + 2. * diagonal) /
             60.;
    }

    /// One triangle of the fan of a polygon.
    struct Fan
    {
      std::array<const Vertex *, 3> vertex;
      double                        area;
      Corners                       weight;

      Fan(Symmetry symmetry, const Polygon &polygon, int i)
        : vertex{{&polygon.vertex[0], &polygon.vertex[i], &polygon.vertex[i + 1]}}
        , area(0.5 * double_area(vertex[0]->x, vertex[1]->x, vertex[2]->x))
      {
        for (int j = 0; j < 3; ++j)
          weight[j] = symmetry == Symmetry::planar ? 1. : 2. * std::numbers::pi * vertex[j]->x[0];
      }

      Corners
      values(Vector<2> Vertex::*field, int axis, double reference) const
      {
        return {{(vertex[0]->*field)[axis] - reference, (vertex[1]->*field)[axis] - reference,
                 (vertex[2]->*field)[axis] - reference}};
      }
    };
  } // namespace

  double
  signed_double_area(const Triangle &triangle)
  {
    return double_area(triangle[0].x, triangle[1].x, triangle[2].x);
  }

  Polygon
  as_polygon(const Triangle &triangle)
  {
    Polygon polygon;
    polygon.size = 3;
    std::copy(triangle.begin(), triangle.end(), polygon.vertex.begin());
    return polygon;
  }

  void
  bounds(std::span<const Triangle> triangles, Vector<2> &lower, Vector<2> &upper)
  {
    lower = upper = triangles[0][0].x;
    for (const Triangle &triangle : triangles)
      for (const Vertex &v : triangle)
        for (int d = 0; d < 2; ++d)
          {
            lower[d] = std::min(lower[d], v.x[d]);
            upper[d] = std::max(upper[d], v.x[d]);
          }
  }

  Polygon
  clip(const Triangle &triangle, const Vector<2> &lower, const Vector<2> &upper)
  {
    Polygon polygon = as_polygon(triangle);
    for (int axis = 0; axis < 2; ++axis)
      {
        cut(polygon, axis, 1., upper[axis]);
        cut(polygon, axis, -1., lower[axis]);
      }
    if (polygon.size < 3)
      polygon.size = 0;
    return polygon;
  }

  Moments
  moments(Symmetry symmetry, const Polygon &polygon)
  {
    Moments         result;
    const Vector<2> x0 = polygon.vertex[0].x, u0 = polygon.vertex[0].u;
    Vector<2>       first_x{}, first_u{};
    for (int i = 1; i + 1 < polygon.size; ++i)
      {
        const Fan fan(symmetry, polygon, i);
        result.volume += fan.area * sum(fan.weight) / 3.;
        for (int d = 0; d < 2; ++d)
          {
            first_x[d] += fan.area * mean_product(fan.weight, fan.values(&Vertex::x, d, x0[d]));
            first_u[d] += fan.area * mean_product(fan.weight, fan.values(&Vertex::u, d, u0[d]));
          }
      }
    if (!(result.volume > 0))
      return {};
    for (int d = 0; d < 2; ++d)
      {
        result.mean_x[d] = x0[d] + first_x[d] / result.volume;
        result.mean_u[d] = u0[d] + first_u[d] / result.volume;
      }
    for (int i = 1; i + 1 < polygon.size; ++i)
      {
        const Fan              fan(symmetry, polygon, i);
        std::array<Corners, 2> x, u;
        for (int d = 0; d < 2; ++d)
          {
            x[d] = fan.values(&Vertex::x, d, result.mean_x[d]);
            u[d] = fan.values(&Vertex::u, d, result.mean_u[d]);
          }
        for (int a = 0; a < 2; ++a)
          {
            for (int b = 0; b < 2; ++b)
              {
                result.xx[a][b] += fan.area * mean_product(fan.weight, x[a], x[b]);
                result.ux[a][b] += fan.area * mean_product(fan.weight, u[a], x[b]);
              }
            result.uu += fan.area * mean_product(fan.weight, u[a], u[a]);
          }
      }
    return result;
  }

  Bisection
  bisect(const CornerVectors<2> &x, const CornerVectors<2> &u)
  {
    const auto triangle = [&](int a, int b, int c) {
      Triangle   t;
      const auto corner = {a, b, c};
      auto       vertex = t.begin();
      for (const int k : corner)
        *vertex++ = {{{x[0][k], x[1][k]}}, {{u[0][k], u[1][k]}}};
      return t;
    };
    const auto smaller = [](const std::array<Triangle, 2> &pair) {
      return std::min(signed_double_area(pair[0]), signed_double_area(pair[1]));
    };
    const std::array<Triangle, 2> rising{{triangle(0, 1, 3), triangle(0, 3, 2)}};
    const std::array<Triangle, 2> falling{{triangle(0, 1, 2), triangle(1, 3, 2)}};

    Bisection result{smaller(rising) >= smaller(falling) ? rising : falling};
    for (Triangle &t : result.triangle)
      if (signed_double_area(t) < 0)
        {
          std::swap(t[1], t[2]);
          result.folded = true;
        }
    return result;
  }

  Triangle
  shrink(const Triangle &triangle, double c)
  {
    Triangle result = triangle;
    for (int d = 0; d < 2; ++d)
      {
        const double centroid = (triangle[0].x[d] + triangle[1].x[d] + triangle[2].x[d]) / 3.;
        for (Vertex &v : result)
          v.x[d] = c * v.x[d] + (1. - c) * centroid;
      }
    return result;
  }
} // namespace whipple::projection
