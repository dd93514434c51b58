// SPDX-License-Identifier: LGPL-2.1-or-later
#include <whipple/hydro/deviator.h>

#include <gtest/gtest.h>

#include <cmath>

namespace
{
  using namespace whipple;

  TEST(Deviator, UniaxialStress)
  {
    // sigma along axis 1: s = sigma (-1/3, 2/3), hoop -1/3
    const double      sigma = 0.012;
    const Deviator<2> s{{-sigma / 3., 2. * sigma / 3., 0.}};
    EXPECT_NEAR(s.equivalent(), sigma, 1e-17);
    EXPECT_NEAR(s.least_principal(), -sigma / 3., 1e-17);
    EXPECT_EQ(s.normal(1), 2. * sigma / 3.);
  }

  TEST(Deviator, LeastPrincipalValueOfShearAndOfHoopStress)
  {
    EXPECT_DOUBLE_EQ((Deviator<2>{{0., 0., 0.003}}.least_principal()), -0.003);
    EXPECT_DOUBLE_EQ((Deviator<2>{{0.002, 0.004, 0.}}.least_principal()), -0.006); // out of the plane
    // eigenvalues of [[3, 2], [2, 0]]: 4 and -1; hoop -3
    EXPECT_DOUBLE_EQ((Deviator<2>{{3., 0., 2.}}.least_principal()), -3.);
    // of [[1, 2], [2, -2]]: 2 and -3; hoop 1
    EXPECT_DOUBLE_EQ((Deviator<2>{{1., -2., 2.}}.least_principal()), -3.);
  }

  TEST(Deviator, ReturnGoesStraightToTheYieldSurface)
  {
    const Deviator<2> trial{{0.004, -0.002, 0.003}};
    const double      size = trial.equivalent(), yield = 0.5 * size;
    const Deviator<2> s = returned(trial, size, yield);
    EXPECT_NEAR(s.equivalent(), yield, 1e-17);
    for (std::size_t i = 0; i < s.component.size(); ++i)
      EXPECT_NEAR(s.component[i], 0.5 * trial.component[i], 1e-17);
    EXPECT_EQ(returned(trial, size, 2. * size).component, trial.component);
    EXPECT_NEAR(plastic_increment(size, yield, 0.25), (size - yield) / 0.75, 1e-17);
    EXPECT_EQ(plastic_increment(size, yield, 0.), 0.);
  }

  TEST(Deviator, PullsACornerOfASquareByTheStressOnHalfItsSides)
  {
    // planar, square of side h: a corner feels stress . (area vector of half of each of its sides)
    const double           h = 0.2;
    const CornerVectors<2> x = CellShape<2>::box({{0., 0.}}, {{h, h}});
    using Cell               = CellGeometry<2, Symmetry::planar>;
    const Deviator<2> s{{0.001, 0.002, -0.0005}};
    const auto        pull = s.pull(shape_gradient<2>(3, Cell::volume_gradient(x), Cell::hoop_weight(x)), 0.);
    EXPECT_NEAR(pull[0], 0.5 * h * (0.001 - 0.0005), 1e-18);
    EXPECT_NEAR(pull[1], 0.5 * h * (-0.0005 + 0.002), 1e-18);
  }

  TEST(Deviator, RateOfAUniformExpansionIsNone)
  {
    const DeformationRate<2, double> even(VelocityGradient<2, double>{{{{0.3, 0.}, {0., 0.3}}}, 0.3});
    for (const double component : even.deviator.component)
      EXPECT_NEAR(component, 0., 1e-16);
    const DeformationRate<2, double> turning(VelocityGradient<2, double>{{{{0., -0.7}, {0.7, 0.}}}, 0.});
    EXPECT_EQ(turning.spin, 0.7);
    for (const double component : turning.deviator.component)
      EXPECT_EQ(component, 0.);
  }

  TEST(Deviator, IsStoredAsFieldsThatAMirrorTurnsRoundOrNot)
  {
    MaterialState material;
    for (const double value : {9., 1., 2., 3.})
      material.fields.push_back({{"", "", Carrier::volume}, {0., value}});
    FieldIndex<2> index;
    EXPECT_FALSE(index.has_stress());
    index.stress = {1, 2, 3};
    EXPECT_TRUE(index.has_stress());
    EXPECT_EQ(StoredDeviator<2>(material, index).at(1).component, (std::array<double, 3>{1., 2., 3.}));
    EXPECT_EQ(index.odd_at(0), (std::array<int, 1>{3})); // shear alone
    EXPECT_EQ(index.odd_at(1), (std::array<int, 1>{3}));
  }
} // namespace
