// SPDX-License-Identifier: LGPL-2.1-or-later
#include <whipple/remap/interface_plane.h>

#include <gtest/gtest.h>

#include <algorithm>
#include <cmath>
#include <numbers>
#include <random>
#include <vector>

namespace
{
  using whipple::Symmetry;
  using Point = whipple::Vector<2>;

  /// Independent measure: clip the box polygon against the half-space, then the shoelace sums of area and r-moment.
  double
  clipped_volume(const Symmetry symmetry, const Point &lower, const Point &upper, const Point &origin,
                 const Point &normal, const double offset)
  {
    const std::vector<Point> box{lower, {upper[0], lower[1]}, upper, {lower[0], upper[1]}};
    std::vector<Point>       polygon;
    const auto               distance = [&](const Point &p) {
      return normal[0] * (p[0] - origin[0]) + normal[1] * (p[1] - origin[1]) - offset;
    };
    for (int i = 0; i < 4; ++i)
      {
        const Point &p = box[i], &q = box[(i + 1) % 4];
        const double dp = distance(p), dq = distance(q);
        if (dp <= 0)
          polygon.push_back(p);
        if ((dp < 0 && dq > 0) || (dp > 0 && dq < 0))
          {
            const double s = dp / (dp - dq);
            polygon.push_back({p[0] + s * (q[0] - p[0]), p[1] + s * (q[1] - p[1])});
          }
      }
    double sum = 0;
    for (std::size_t i = 1; i + 1 < polygon.size(); ++i)
      {
        const Point &p = polygon[0], &q = polygon[i], &s = polygon[i + 1];
        const double area = 0.5 * ((q[0] - p[0]) * (s[1] - p[1]) - (q[1] - p[1]) * (s[0] - p[0]));
        sum += symmetry == Symmetry::planar ? area : 2. * std::numbers::pi * area * (p[0] + q[0] + s[0]) / 3.;
      }
    return sum;
  }

  double
  box_volume(const Symmetry symmetry, const Point &lower, const Point &upper)
  {
    const double area = (upper[0] - lower[0]) * (upper[1] - lower[1]);
    return symmetry == Symmetry::planar ? area : std::numbers::pi * (lower[0] + upper[0]) * area;
  }

  struct Sample
  {
    Point lower, upper, normal;
  };

  /// Boxes at the axis and far away, normals in all directions, also almost along an axis and exactly along it.
  Sample
  sample(std::mt19937 &random, const int i)
  {
    std::uniform_real_distribution<double> unit(0., 1.);
    Sample                                 s;
    s.lower                = {i % 3 == 0 ? 0. : (i % 3 == 1 ? 0.004 : 1.) * unit(random), unit(random) - 0.5};
    s.upper                = {s.lower[0] + 0.004, s.lower[1] + 0.004 * (0.2 + unit(random))};
    double       angle     = 2. * std::numbers::pi * unit(random);
    const double deviation = std::pow(10., -18. * unit(random));
    if (i % 4 == 1)
      angle = 0.5 * std::numbers::pi * std::floor(4. * unit(random)) + deviation;
    s.normal = {std::cos(angle), std::sin(angle)};
    if (i % 8 == 2)
      s.normal = {0., i % 16 == 2 ? 1. : -1.};
    if (i % 8 == 6)
      s.normal = {i % 16 == 6 ? 1. : -1., 0.};
    return s;
  }
} // namespace

TEST(InterfacePlane, VolumeAgreesWithClippedPolygon)
{
  std::mt19937                           random(1);
  std::uniform_real_distribution<double> unit(0., 1.);
  for (const Symmetry symmetry : {Symmetry::planar, Symmetry::axisymmetric})
    for (int i = 0; i < 20000; ++i)
      {
        const Sample s = sample(random, i);
        const Point  origin{s.lower[0] - 0.004 * unit(random), s.lower[1] + 0.002 * unit(random)};
        const double offset = 0.006 * (2. * unit(random) - 1.);
        const double volume =
            whipple::interface_plane::volume_below<2>(symmetry, s.lower, s.upper, origin, s.normal, offset);
        EXPECT_NEAR(volume, clipped_volume(symmetry, s.lower, s.upper, origin, s.normal, offset),
                    2e-12 * box_volume(symmetry, s.lower, s.upper));
      }
}

TEST(InterfacePlane, InverseIsExactToRoundOff)
{
  std::mt19937                           random(2);
  std::uniform_real_distribution<double> unit(0., 1.);
  double                                 worst = 0;
  for (const Symmetry symmetry : {Symmetry::planar, Symmetry::axisymmetric})
    for (int i = 0; i < 20000; ++i)
      {
        const Sample s        = sample(random, i);
        const double decades  = std::pow(10., -12. * unit(random));
        const double fraction = i % 5 == 0 ? decades : i % 5 == 1 ? 1. - decades : unit(random);
        const double offset =
            whipple::interface_plane::offset_of_fraction<2>(symmetry, s.lower, s.upper, s.normal, fraction);
        const double volume =
            whipple::interface_plane::volume_below<2>(symmetry, s.lower, s.upper, s.lower, s.normal, offset);
        worst = std::max(worst, std::abs(volume / box_volume(symmetry, s.lower, s.upper) - fraction));
      }
  EXPECT_LT(worst, 4e-15);
  RecordProperty("worst_fraction_error", std::to_string(worst));
}

TEST(InterfacePlane, EmptyAndFullBoxes)
{
  const Point lower{0., 1.}, upper{0.5, 2.}, normal{-0.6, 0.8};
  for (const Symmetry symmetry : {Symmetry::planar, Symmetry::axisymmetric})
    {
      EXPECT_EQ(whipple::interface_plane::volume_below<2>(symmetry, lower, upper, lower, normal, -0.31), 0.);
      EXPECT_DOUBLE_EQ(whipple::interface_plane::volume_below<2>(symmetry, lower, upper, lower, normal, 0.81),
                       box_volume(symmetry, lower, upper));
      EXPECT_DOUBLE_EQ(whipple::interface_plane::offset_of_fraction<2>(symmetry, lower, upper, normal, 0.), -0.3);
      EXPECT_DOUBLE_EQ(whipple::interface_plane::offset_of_fraction<2>(symmetry, lower, upper, normal, 1.), 0.8);
    }
}
