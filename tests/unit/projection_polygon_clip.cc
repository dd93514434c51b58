// SPDX-License-Identifier: LGPL-2.1-or-later
#include "projection_fixture.h"

#include <whipple/mesh/polygon_clip.h>

#include <gtest/gtest.h>

#include <algorithm>
#include <numbers>

namespace
{
  using namespace whipple;
  using namespace whipple::projection;

  Triangle
  random_triangle(projection_test::Random &random, double low)
  {
    Triangle t;
    for (Vertex &v : t)
      v = {{{random(low, 1.), random(-1., 1.)}}, {{random(-1., 1.), random(-1., 1.)}}};
    if (signed_double_area(t) < 0)
      std::swap(t[0], t[1]);
    return t;
  }

  /// The linear velocity of a triangle by Cramer's rule.
  Vector<2>
  velocity_at(const Triangle &t, double x, double y)
  {
    const double area = signed_double_area(t);
    const auto   part = [&](const Vertex &a, const Vertex &b) {
      return ((b.x[0] - a.x[0]) * (y - a.x[1]) - (b.x[1] - a.x[1]) * (x - a.x[0])) / area;
    };
    const double l0 = part(t[1], t[2]), l1 = part(t[2], t[0]), l2 = part(t[0], t[1]);
    return {{l0 * t[0].u[0] + l1 * t[1].u[0] + l2 * t[2].u[0], l0 * t[0].u[1] + l1 * t[1].u[1] + l2 * t[2].u[1]}};
  }

  /// Integral over triangle and box by Gauss quadrature in strips between the places where the bounds of y kink;
  /// no clipping involved.
  template <typename Function>
  double
  strip_integral(const Triangle &t, const Vector<2> &lower, const Vector<2> &upper, Function function)
  {
    std::vector<double> kinks{lower[0], upper[0]};
    for (int i = 0; i < 3; ++i)
      {
        const Vector<2> &a = t[i].x, &b = t[(i + 1) % 3].x;
        kinks.push_back(a[0]);
        for (const double y : {lower[1], upper[1]})
          kinks.push_back(a[0] + (y - a[1]) / (b[1] - a[1]) * (b[0] - a[0]));
      }
    for (double &x : kinks)
      x = std::clamp(x, lower[0], upper[0]);
    std::sort(kinks.begin(), kinks.end());

    constexpr std::array<double, 4> point{
        {-0.8611363115940526, -0.3399810435848563, 0.3399810435848563, 0.8611363115940526}};
    constexpr std::array<double, 4> weight{
        {0.3478548451374538, 0.6521451548625461, 0.6521451548625461, 0.3478548451374538}};
    double sum = 0;
    for (std::size_t s = 0; s + 1 < kinks.size(); ++s)
      for (int i = 0; i < 4; ++i)
        {
          const double half = 0.5 * (kinks[s + 1] - kinks[s]), x = kinks[s] + half * (1. + point[i]);
          double       bottom = 1e9, top = -1e9;
          for (int e = 0; e < 3; ++e)
            {
              const Vector<2> &a = t[e].x, &b = t[(e + 1) % 3].x;
              if ((a[0] - x) * (b[0] - x) < 0)
                {
                  const double y = a[1] + (x - a[0]) / (b[0] - a[0]) * (b[1] - a[1]);
                  bottom         = std::min(bottom, y);
                  top            = std::max(top, y);
                }
            }
          bottom = std::max(bottom, lower[1]);
          top    = std::min(top, upper[1]);
          if (top <= bottom)
            continue;
          const double height = 0.5 * (top - bottom);
          for (int j = 0; j < 4; ++j)
            sum += half * weight[i] * height * weight[j] * function(x, bottom + height * (1. + point[j]));
        }
    return sum;
  }

  void
  compare(Symmetry symmetry, const Triangle &t, const Vector<2> &lower, const Vector<2> &upper)
  {
    const Moments m  = moments(symmetry, clip(t, lower, upper));
    const auto    of = [&](auto f) {
      return strip_integral(t, lower, upper, [&](double x, double y) {
        const double w = symmetry == Symmetry::planar ? 1. : 2. * std::numbers::pi * x;
        return w * f(x, y, velocity_at(t, x, y));
      });
    };
    const double scale = 1e-13 * 10.;
    EXPECT_NEAR(m.volume, of([](double, double, Vector<2>) { return 1.; }), scale);
    EXPECT_NEAR(m.volume * m.mean_x[0], of([](double x, double, Vector<2>) { return x; }), scale);
    EXPECT_NEAR(m.volume * m.mean_x[1], of([](double, double y, Vector<2>) { return y; }), scale);
    EXPECT_NEAR(m.volume * m.mean_u[0], of([](double, double, Vector<2> u) { return u[0]; }), scale);
    EXPECT_NEAR(m.volume * m.mean_u[1], of([](double, double, Vector<2> u) { return u[1]; }), scale);
    EXPECT_NEAR(m.uu + m.volume * (m.mean_u[0] * m.mean_u[0] + m.mean_u[1] * m.mean_u[1]),
                of([](double, double, Vector<2> u) { return u[0] * u[0] + u[1] * u[1]; }), scale);
    EXPECT_NEAR(m.xx[0][1] + m.volume * m.mean_x[0] * m.mean_x[1],
                of([](double x, double y, Vector<2>) { return x * y; }), scale);
    EXPECT_NEAR(m.ux[1][0] + m.volume * m.mean_u[1] * m.mean_x[0],
                of([](double x, double, Vector<2> u) { return u[1] * x; }), scale);
  }
} // namespace

TEST(PolygonClip, MomentsOfRandomTrianglesInRandomBoxes)
{
  projection_test::Random random(1);
  for (int i = 0; i < 2000; ++i)
    {
      const Triangle t = random_triangle(random, 0.);
      if (signed_double_area(t) < 0.05) // the reference evaluates the velocity by Cramer's rule
        continue;
      Vector<2> lower{{random(0., 0.9), random(-1., 0.9)}}, upper;
      if (i % 3 == 0)
        lower[0] = 0; // a cell at the axis
      for (int d = 0; d < 2; ++d)
        upper[d] = lower[d] + random(0.05, 1.);
      compare(i % 2 ? Symmetry::axisymmetric : Symmetry::planar, t, lower, upper);
    }
}

TEST(PolygonClip, ConeWithACornerOnTheAxis)
{
  const Triangle t{{{{{0., 0.}}, {}}, {{{1., 0.}}, {}}, {{{0., 1.}}, {}}}};
  const Moments  m = moments(Symmetry::axisymmetric, clip(t, {{0., 0.}}, {{2., 2.}}));
  EXPECT_NEAR(m.volume, std::numbers::pi / 3., 1e-15);
  EXPECT_NEAR(m.mean_x[1], 0.25, 1e-15);
}

TEST(PolygonClip, PiecesOfATilingAddUp)
{
  projection_test::Random random(2);
  for (int i = 0; i < 200; ++i)
    {
      const Triangle t     = random_triangle(random, 0.);
      const double   whole = moments(Symmetry::axisymmetric, as_polygon(t)).volume;
      double         sum   = 0;
      for (int a = 0; a < 8; ++a)
        for (int b = -8; b < 8; ++b)
          sum += moments(Symmetry::axisymmetric, clip(t, {{a / 8., b / 8.}}, {{(a + 1) / 8., (b + 1) / 8.}})).volume;
      EXPECT_NEAR(sum, whole, 1e-14);
    }
}

TEST(PolygonClip, UniformVelocityKeepsItsBits)
{
  projection_test::Random random(3);
  for (int i = 0; i < 100; ++i)
    {
      Triangle t = random_triangle(random, 0.);
      for (Vertex &v : t)
        v.u = {{0.1234567, 0.658}};
      const Moments m = moments(Symmetry::axisymmetric, clip(t, {{0.2, -0.3}}, {{0.6, 0.4}}));
      if (m.volume > 0)
        {
          EXPECT_EQ(m.mean_u[0], 0.1234567);
          EXPECT_EQ(m.mean_u[1], 0.658);
          EXPECT_EQ(m.uu, 0.);
        }
    }
}

TEST(PolygonClip, NonConvexQuadIsCutAtItsReflexCorner)
{
  const CornerVectors<2> dart{{{{0., 1., 0., 0.2}}, {{0., 0., 1., 0.2}}}}; // corner 3 pushed inside
  const Bisection        cut = bisect(dart, {});
  EXPECT_FALSE(cut.folded);
  EXPECT_GT(signed_double_area(cut.triangle[0]), 0.);
  EXPECT_GT(signed_double_area(cut.triangle[1]), 0.);
  EXPECT_NEAR(signed_double_area(cut.triangle[0]) + signed_double_area(cut.triangle[1]), 2. * CellShape<2>::area(dart),
              1e-15);
}

TEST(PolygonClip, FoldedQuadIsTurnedOver)
{
  const CornerVectors<2> bow_tie{{{{0., 1., 1.2, 0.}}, {{0., 0., 1., 1.}}}};
  const Bisection        cut = bisect(bow_tie, {});
  EXPECT_TRUE(cut.folded);
  for (const Triangle &t : cut.triangle)
    EXPECT_GE(signed_double_area(t), 0.);
}

TEST(PolygonClip, ShrunkTriangleObeysPappus)
{
  projection_test::Random random(4);
  for (int i = 0; i < 100; ++i)
    {
      const Triangle t = random_triangle(random, 0.);
      const double   c = random(0.05, 1.);
      const double   v = moments(Symmetry::axisymmetric, as_polygon(t)).volume;
      EXPECT_NEAR(moments(Symmetry::axisymmetric, as_polygon(shrink(t, c))).volume, c * c * v, 1e-14);
    }
}
