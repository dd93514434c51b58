// SPDX-License-Identifier: LGPL-2.1-or-later
#include <whipple/mesh/cell_geometry.h>
#include <whipple/mesh/flat_mesh.h>

#include <gtest/gtest.h>

#include <numbers>

namespace
{
  using namespace whipple;

  TEST(CellGeometry, RingOfARectangle)
  {
    const CornerVectors<2> x  = CellShape<2>::box({{1., 2.}}, {{3., 7.}});
    constexpr double       pi = std::numbers::pi;
    EXPECT_DOUBLE_EQ(cell_volume(Symmetry::planar, x), 10.);
    EXPECT_NEAR(cell_volume(Symmetry::axisymmetric, x), pi * (9. - 1.) * 5., 1e-12);
    // of linear functions of the radius: int r (3 - r)/2 dr = 5/3 inside, 7/3 outside, times half the height and 2 pi
    const CornerValues<2> share = corner_volume(Symmetry::axisymmetric, x);
    for (int k = 0; k < 4; ++k)
      EXPECT_NEAR(share[k], 2. * pi * 2.5 * (k & 1 ? 7. / 3. : 5. / 3.), 1e-12);
  }

  TEST(CellGeometry, ExtentsOfARectangle)
  {
    const CornerVectors<2> x = CellShape<2>::box({{1., 2.}}, {{3., 7.}});
    EXPECT_DOUBLE_EQ(CellShape<2>::smallest_extent(x), 2.); // area 10 over the side 5
    using Plane = CellGeometry<2, Symmetry::planar>;
    using Ring  = CellGeometry<2, Symmetry::axisymmetric>;
    EXPECT_DOUBLE_EQ(Plane::mean_extent(Plane::volume(x), Plane::hoop_weight(x)), std::sqrt(10.));
    EXPECT_DOUBLE_EQ(Ring::mean_extent(Ring::volume(x), Ring::hoop_weight(x)), std::sqrt(10.));
    EXPECT_EQ(CellShape<2>::middle(x), (Vector<2>{{2., 4.5}}));
  }

  TEST(CellGeometry, SmallestExtentOfAFlatRhombusIsItsShortDiagonalOverRootTwo)
  {
    // long diagonal 2 a, short 2 b << a: area 2 a b over sqrt(2) a
    const double           a = 1., b = 0.01;
    const CornerVectors<2> x{{{{-a, 0., 0., a}}, {{0., -b, b, 0.}}}};
    EXPECT_NEAR(CellShape<2>::smallest_extent(x), std::numbers::sqrt2 * b, 1e-15);
  }

  TEST(CellGeometry, WhatIsFoldedAndWhatCrosses)
  {
    using Shape        = CellShape<2>;
    CornerVectors<2> x = Shape::box({{0., 0.}}, {{1., 1.}});
    EXPECT_DOUBLE_EQ(Shape::convexity(x), 1.);
    EXPECT_FALSE(Shape::folds(x, 0.99));
    EXPECT_FALSE(Shape::crosses(x));

    x[0][3] = x[1][3] = 0.4; // an arrowhead: one reflex corner, and an area of its own
    EXPECT_LT(Shape::convexity(x), 0.);
    EXPECT_TRUE(Shape::folds(x, 0.));
    EXPECT_FALSE(Shape::crosses(x));

    x = {{{{0., 1., 1.2, 0.}}, {{0., 0., 1., 1.}}}}; // a bow tie
    EXPECT_TRUE(Shape::crosses(x));
    x = {{{{1., 0., 1., 0.}}, {{0., 0., 1., 1.}}}}; // a square seen from behind
    EXPECT_TRUE(Shape::crosses(x));
    EXPECT_TRUE(Shape::folds(x, 0.));
  }

  TEST(FlatMesh, HangingNodesFollowTheirMastersAndGiveThemWhatTheyHold)
  {
    FlatMesh<2> mesh;
    mesh.hanging = {1, 4};
    mesh.master  = {{{{0, 2}}}, {{{2, 3}}}};
    std::vector<double> v{1., 0., 5., -3., 0.};
    mesh.hang(v);
    EXPECT_EQ(v, (std::vector<double>{1., 3., 5., -3., 1.}));
    EXPECT_DOUBLE_EQ(mesh.master[0].mean([](Index n) { return 10. * n; }), 10.);
    std::vector<double> m{1., 4., 1., 1., 2.};
    mesh.share_out(m);
    EXPECT_EQ(m, (std::vector<double>{3., 4., 4., 2., 2.}));
  }
} // namespace
