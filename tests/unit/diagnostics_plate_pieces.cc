// SPDX-License-Identifier: LGPL-2.1-or-later
// What of a plate counts when it has come apart: pieces, rims, debris of its own material.
#include "plate_scenery.h"

#include <random>

namespace
{
  using namespace whipple;
  using namespace whipple::plate_scenery;

  TEST(PlatePieces, SplitInTwoPieces)
  {
    const Scenery s{Symmetry::planar, 96, 96, 6., 40., 0., false};
    // pulled apart along axis 0, one half ahead of the other
    const PlateMeasure apart =
        s.measure([&](double x, double z) { return x < 0 ? s.in_plate(x, z) : x > 4. && s.in_plate(x, z - 2.); });
    EXPECT_TRUE(apart.perforated);
    EXPECT_NEAR(apart.smallest_hole_diameter, 4., 0.1);
    EXPECT_NEAR(apart.hole_diameter, std::hypot(4., 2.), 0.3);
    EXPECT_NEAR(apart.detached_mass, 0., 1e-6);
    // sheared through obliquely: no straight way, yet in two
    const PlateMeasure sheared =
        s.measure([&](double x, double z) { return s.in_plate(x, z) && (x < z - 5. || x > z - 5. + 2.5); });
    EXPECT_TRUE(sheared.perforated);
    EXPECT_EQ(sheared.smallest_hole_diameter, 0.);
    EXPECT_NEAR(sheared.hole_diameter, 2.5, 0.3);
    EXPECT_NEAR(sheared.perforation_margin, 2.5, 0.3);
  }

  TEST(PlatePieces, DebrisOfItsOwnDoesNotCloseTheHole)
  {
    const Scenery s{Symmetry::axisymmetric, 64, 96, 5.};
    const auto    plate  = [&](double x, double z) { return s.in_plate(x, z) && x > 12.4; };
    const auto    debris = [](double x, double z) {
      return std::hypot(x, z - 2.5) < 6. || std::hypot(x - 20., z + 20.) < 4. || std::hypot(x - 30., z - 25.) < 5.;
    };
    const PlateMeasure bare = s.measure(plate);
    const PlateMeasure m    = s.measure([&](double x, double z) { return plate(x, z) || debris(x, z); });
    EXPECT_TRUE(m.perforated);
    EXPECT_EQ(m.hole_diameter, bare.hole_diameter);
    EXPECT_EQ(m.smallest_hole_diameter, bare.smallest_hole_diameter);
    EXPECT_EQ(m.front_lip, bare.front_lip);
    EXPECT_EQ(m.rear_bulge, bare.rear_bulge);
    const double pi       = std::numbers::pi;
    const double expected = 4. / 3. * pi * 216. + 2. * pi * pi * (20. * 16. + 30. * 25.);
    EXPECT_NEAR(m.detached_mass, expected, 0.005 * expected);
    // the same before and behind a whole plate
    const auto loose = [](double x, double z) { return std::hypot(x, z + 15.) < 8. || (z > 8. && z < 9. && x < 9.); };
    const PlateMeasure whole = s.measure([&](double x, double z) { return s.in_plate(x, z) || loose(x, z); });
    expect_whole(whole);
    EXPECT_NEAR(whole.crater_depth, 0., 0.02);
    EXPECT_NEAR(whole.rear_bulge, 0., 0.02);
    EXPECT_GT(whole.detached_mass, 4. / 3. * pi * 500.);
  }

  // A cloud of own material, however much of it, bars nothing where it is thinner than half the plate's density.
  TEST(PlatePieces, DistendedCloudInTheHoleBarsNothing)
  {
    const Scenery          s{Symmetry::axisymmetric, 64, 64, 5.};
    std::vector<PlateCell> cells = s.paint([&](double x, double z) { return s.in_plate(x, z) && x > 12.4; });
    for (int i = 0; i < 12; ++i)
      for (int j = 28; j < 60; ++j)
        cells.push_back(s.cell([](double, double) { return true; }, i, j, 1, 0.3));
    const auto m = measure_plate(s.site(), cells);
    ASSERT_TRUE(m);
    EXPECT_TRUE(m->perforated);
    EXPECT_NEAR(m->hole_diameter, 24.8, 0.2);
    EXPECT_GT(m->detached_mass, 0.29 * 144. * std::numbers::pi * 32.);
  }

  TEST(PlatePieces, FragmentedRim)
  {
    Scenery    s{Symmetry::planar, 96, 64, 5., 36., 0., false};
    const auto rim = [](double x) { return std::abs(x) > 28.; };
    for (const double hole : {0., 8.4})
      {
        const PlateMeasure m = s.measure([&](double x, double z) {
          return s.in_plate(x, z) && (rim(x) ? std::fmod(std::abs(x), 4.) > 1.6 : std::abs(x) >= 0.5 * hole);
        });
        EXPECT_EQ(m.perforated, hole > 0);
        EXPECT_NEAR(m.hole_diameter, hole, 0.1);
        EXPECT_GT(m.detached_mass, 0.);
        if (hole == 0.)
          {
            EXPECT_NEAR(m.least_thickness, 5., 0.05);
          }
      }
  }

  TEST(PlatePieces, ShatteredPlateIsAllHole)
  {
    const Scenery      s{Symmetry::planar, 96, 64, 5., 36., 0., false};
    const PlateMeasure m =
        s.measure([&](double x, double z) { return s.in_plate(x, z) && std::fmod(std::abs(x), 4.) > 1.6; });
    EXPECT_TRUE(m.perforated);
    EXPECT_EQ(m.hole_diameter, 72.);
    EXPECT_EQ(m.crater_depth, 5.);
    EXPECT_NEAR(m.detached_mass, 0.6 * 72. * 5., 1.);
  }

  TEST(PlatePieces, LostRim)
  {
    const Scenery s{Symmetry::planar, 96, 64, 5., infinite, 0., false};
    for (const bool mirrored : {false, true})
      {
        const PlateMeasure m =
            s.measure([&](double x, double z) { return s.in_plate(x, z) && (mirrored ? -x : x) > -7.6; });
        EXPECT_TRUE(m.perforated);
        EXPECT_NEAR(m.hole_diameter, 48. - 7.6, 0.1);
        EXPECT_NEAR(m.smallest_hole_diameter, 48. - 7.6, 0.1);
      }
    // drawn back a little from the sides
    const PlateMeasure whole = s.measure([&](double x, double z) { return s.in_plate(x, z) && std::abs(x) < 44.3; });
    expect_whole(whole);
  }

  // Whatever the cells hold: an answer, finite numbers, and the signs that belong to the verdict.
  TEST(PlatePieces, AnyCloudIsMeasured)
  {
    std::mt19937                           random(42);
    std::uniform_real_distribution<double> uniform(0., 1.);
    for (int k = 0; k < 400; ++k)
      {
        const bool    round = k % 3 == 0;
        const Scenery s{round ? Symmetry::axisymmetric : Symmetry::planar,
                        16,
                        16,
                        1. + 4. * uniform(random),
                        k % 2 ? infinite : 5. + 5. * uniform(random),
                        0.,
                        round || k % 3 == 1};
        std::vector<PlateCell> cells;
        const double           density = uniform(random);
        for (int i = 0; i < 16; i += 2)
          for (int j = 0; j < 16; j += 2)
            for (int child = 0; child < 4; ++child)
              if (const bool coarse = (i + j) % 3 == 0; (!coarse || child == 0) && uniform(random) < density)
                {
                  PlateCell cell{{{i + (coarse ? 0 : child % 2), j + (coarse ? 0 : child / 2)}}, coarse ? 2 : 1};
                  cell.fill  = uniform(random);
                  cell.solid = cell.fill * uniform(random);
                  cell.mass  = cell.solid * cell.size * cell.size * s.weight(i + 1.);
                  cell.dense = cell.solid > 0.5 * cell.fill;
                  cells.push_back(cell);
                }
        const auto m = measure_plate(s.site(), cells);
        if (!m)
          continue;
        for (const double value : {m->perforation_margin, m->hole_diameter, m->smallest_hole_diameter, m->crater_depth,
                                   m->rear_bulge, m->front_lip, m->least_thickness, m->detached_mass})
          EXPECT_TRUE(std::isfinite(value)) << k;
        EXPECT_EQ(m->perforated, m->perforation_margin >= 0) << k;
        EXPECT_GE(m->smallest_hole_diameter, 0.) << k;
      }
  }
} // namespace
