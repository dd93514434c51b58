// SPDX-License-Identifier: LGPL-2.1-or-later
// Holes and craters of plates painted by formulas, whose answers are known.
#include <whipple/stage/plate_measure.h>

#include <gtest/gtest.h>

#include <cmath>
#include <functional>
#include <limits>
#include <numbers>
#include <random>

namespace
{
  using namespace whipple;

  constexpr double infinite = std::numeric_limits<double>::infinity();

  /// Whether a point (cm) is in the plate.
  using Inside = std::function<bool(double x, double z)>;

  /// A domain of square cells of 1 cm with a plate in it; z = 0 is in the middle of the domain.
  struct Scenery
  {
    Symmetry symmetry = Symmetry::axisymmetric;
    int      columns = 64, rows = 64;
    double   thickness  = 5;
    double   half_width = infinite;
    double   front      = 0;
    bool     half       = true; ///< planar: x from 0 to columns, else from -columns/2 to columns/2

    double
    left() const
    {
      return half ? 0. : -0.5 * columns;
    }
    double
    bottom() const
    {
      return -0.5 * rows;
    }
    double
    weight(double x) const
    {
      return symmetry == Symmetry::axisymmetric ? 2. * std::numbers::pi * x : 1.;
    }

    PlateSite
    site() const
    {
      const double right = std::min(half_width, left() + columns), from = std::max(-half_width, left());
      const double area = symmetry == Symmetry::axisymmetric ? std::numbers::pi * right * right : right - from;
      return {symmetry, {{left(), bottom()}}, 1., columns, {front, thickness, half_width}, thickness * area, half};
    }

    /// A cell with the share of it that is inside, sampled where the boundary passes.
    PlateCell
    cell(const Inside &inside, int i, int j, int size, double solidity = 1) const
    {
      const auto share = [&](int samples) {
        double sum = 0, all = 0;
        for (int a = 0; a < samples; ++a)
          for (int b = 0; b < samples; ++b)
            {
              const double x = left() + i + size * (a + 0.5) / samples, z = bottom() + j + size * (b + 0.5) / samples;
              all += weight(x);
              sum += inside(x, z) ? weight(x) : 0.;
            }
        return sum / all;
      };
      double fill = share(8);
      if (fill > 0 && fill < 1)
        fill = share(64);
      const double volume = size * size * weight(left() + i + 0.5 * size);
      return {{{i, j}}, size, fill, fill * solidity, fill * solidity * volume, solidity > 0.5};
    }

    /// @param size of the cell that holds cell (i, j); cells of `size` are aligned to it
    std::vector<PlateCell>
    paint(
        const Inside &inside, const std::function<int(int, int)> &size = [](int, int) { return 1; }) const
    {
      std::vector<PlateCell> cells;
      for (int i = 0; i < columns; ++i)
        for (int j = 0; j < rows; ++j)
          if (const int s = size(i, j); i % s == 0 && j % s == 0)
            if (const PlateCell c = cell(inside, i, j, s); c.fill > 0)
              cells.push_back(c);
      return cells;
    }

    PlateMeasure
    measure(const Inside &inside) const
    {
      const auto result = measure_plate(site(), paint(inside));
      EXPECT_TRUE(result);
      return result.value_or(PlateMeasure{});
    }

    bool
    in_plate(double x, double z) const
    {
      return std::abs(x) < half_width && z > front && z < front + thickness;
    }
  };

  void
  expect_whole(const PlateMeasure &m)
  {
    EXPECT_FALSE(m.perforated);
    EXPECT_EQ(m.hole_diameter, 0.);
    EXPECT_EQ(m.smallest_hole_diameter, 0.);
    EXPECT_EQ(m.perforation_margin, -m.least_thickness);
  }

  TEST(PlateMeasure, PlateAtRestIsWhole)
  {
    for (const Symmetry symmetry : {Symmetry::planar, Symmetry::axisymmetric})
      for (const bool half : {true, false})
        for (const double thickness : {1., 1.3, 2.5, 5., 20.})
          for (const double front : {0., 0.25, 0.5, -7.85})
            for (const double half_width : {infinite, 20.3})
              {
                if (symmetry == Symmetry::axisymmetric && !half)
                  continue;
                const Scenery      s{symmetry, 64, 64, thickness, half_width, front, half};
                const PlateMeasure m = s.measure([&](double x, double z) { return s.in_plate(x, z); });
                SCOPED_TRACE(testing::Message() << thickness << " at " << front << " half " << half);
                expect_whole(m);
                EXPECT_NEAR(m.least_thickness, thickness, 0.02);
                EXPECT_NEAR(m.crater_depth, 0., 0.02);
                EXPECT_NEAR(m.rear_bulge, 0., 0.02);
                EXPECT_NEAR(m.detached_mass, 0., 1e-6 * s.site().mass);
              }
  }

  TEST(PlateMeasure, HolesAreRightToATenthOfACell)
  {
    std::mt19937                           random(20261130);
    std::uniform_real_distribution<double> radius(2., 40.), offset(0., 1.);
    for (const double thickness : {1.3, 2.5, 5., 20.})
      for (int k = 0; k < 50; ++k)
        {
          const double       r = radius(random);
          const Scenery      s{Symmetry::axisymmetric, 64, 64, thickness, infinite, offset(random), true};
          const PlateMeasure m = s.measure([&](double x, double z) { return s.in_plate(x, z) && x > r; });
          EXPECT_TRUE(m.perforated);
          EXPECT_NEAR(m.hole_diameter, 2. * r, 0.2) << thickness;
          EXPECT_NEAR(m.smallest_hole_diameter, 2. * r, 0.2) << thickness;
          EXPECT_EQ(m.perforation_margin, m.smallest_hole_diameter);
          EXPECT_EQ(m.crater_depth, thickness);
          EXPECT_EQ(m.least_thickness, 0.);
        }
  }

  TEST(PlateMeasure, HoleOffCentreInAPlanarPlate)
  {
    std::mt19937                           random(7);
    std::uniform_real_distribution<double> from(-20., 5.), width(2., 15.);
    for (int k = 0; k < 50; ++k)
      {
        const double       a = from(random), b = a + width(random);
        const Scenery      s{Symmetry::planar, 64, 32, 2.5, k % 2 ? infinite : 29.7, 0.3, false};
        const PlateMeasure m = s.measure([&](double x, double z) { return s.in_plate(x, z) && (x < a || x > b); });
        EXPECT_TRUE(m.perforated);
        EXPECT_NEAR(m.hole_diameter, b - a, 0.1);
        EXPECT_NEAR(m.smallest_hole_diameter, b - a, 0.1);
      }
  }

  TEST(PlateMeasure, HalfAPlanarPlateHasHalfTheHole)
  {
    Scenery            s{Symmetry::planar, 64, 32, 5., 51.3, 0.3, true};
    const PlateMeasure m = s.measure([&](double x, double z) { return s.in_plate(x, z) && x > 7.3; });
    EXPECT_TRUE(m.perforated);
    EXPECT_NEAR(m.hole_diameter, 14.6, 0.1);
    s.half                  = false;
    const PlateMeasure full = s.measure([&](double x, double z) { return s.in_plate(x, z) && std::abs(x) > 7.3; });
    EXPECT_NEAR(full.hole_diameter, 14.6, 0.1);
  }

  /// Depth of a dish of that depth and width.
  double
  dish(double x, double depth, double width)
  {
    return depth * std::exp(-x * x / (width * width));
  }

  TEST(PlateMeasure, DishedPlateIsWhole)
  {
    for (const double thickness : {1.3, 2.5, 5.})
      for (const double depth : {3., 10., 25.})
        {
          const Scenery      s{Symmetry::axisymmetric, 96, 96, thickness};
          const PlateMeasure m = s.measure([&](double x, double z) { return s.in_plate(x, z - dish(x, depth, 20.)); });
          SCOPED_TRACE(testing::Message() << thickness << " dished by " << depth);
          expect_whole(m);
          EXPECT_NEAR(m.crater_depth, depth, 0.15);
          EXPECT_NEAR(m.rear_bulge, depth, 0.15);
          EXPECT_NEAR(m.least_thickness, thickness, 0.05);
        }
  }

  TEST(PlateMeasure, DishedPlateWithAHole)
  {
    for (const double thickness : {1.3, 2.5, 5.})
      for (const double hole : {4.3, 8.6, 14.2})
        {
          const Scenery      s{Symmetry::axisymmetric, 96, 96, thickness};
          const PlateMeasure m =
              s.measure([&](double x, double z) { return x > hole && s.in_plate(x, z - dish(x, 15., 20.)); });
          EXPECT_TRUE(m.perforated);
          EXPECT_NEAR(m.hole_diameter, 2. * hole, 0.5) << thickness;
          EXPECT_NEAR(m.smallest_hole_diameter, 2. * hole, 0.5) << thickness;
        }
  }

  TEST(PlateMeasure, ThinnedPlateIsWholeUntilHalfACellIsLeft)
  {
    for (const double left : {0.6, 0.75, 1., 1.5, 2.})
      for (const double front : {0., 0.2, 0.4, 0.6, 0.8})
        {
          const Scenery      s{Symmetry::axisymmetric, 64, 64, 5., infinite, front};
          const PlateMeasure m = s.measure([&](double x, double z) {
            const double depth = std::max(0., (5. - left) * (1. - x * x / 144.));
            return s.in_plate(x, z) && z > front + depth;
          });
          SCOPED_TRACE(testing::Message() << left << " left at " << front);
          expect_whole(m);
          EXPECT_NEAR(m.least_thickness, left, 0.05);
          // a layer inside one cell may lie anywhere in it
          EXPECT_NEAR(m.crater_depth, 5. - left, 0.25);
        }
    const Scenery      s;
    const PlateMeasure m = s.measure([&](double x, double z) { return s.in_plate(x, z) && z > (x < 3. ? 4.8 : 0.); });
    EXPECT_TRUE(m.perforated); // a film of a fifth of a cell
    EXPECT_NEAR(m.hole_diameter, 6., 0.2);
  }

  // Petals turned backward by 90 degrees: at the bend the hole is as wide as between the petals.
  TEST(PlateMeasure, TornPlateWithPetals)
  {
    const Scenery      s{Symmetry::axisymmetric, 96, 96, 4.};
    const PlateMeasure m = s.measure([&](double x, double z) {
      const double radius = 10.; // of the bend's outer surface about (bend, 0 + radius)
      const double bend   = 22.;
      if (x > bend)
        return s.in_plate(x, z);
      const double distance = std::hypot(x - bend, z - radius);
      if (z < radius)
        return distance < radius && distance > radius - 4.;
      return z < 25. && x > bend - radius && x < bend - radius + 4.;
    });
    EXPECT_TRUE(m.perforated);
    EXPECT_NEAR(m.smallest_hole_diameter, 24., 0.2);
    EXPECT_GT(m.hole_diameter, 24.);
    EXPECT_LT(m.hole_diameter, 34.);
    EXPECT_NEAR(m.rear_bulge, 21., 0.2);
    EXPECT_NEAR(m.front_lip, 0., 0.05);
  }

  TEST(PlateMeasure, LipsDoNotMoveTheMiddle)
  {
    const Scenery      s{Symmetry::axisymmetric, 96, 96, 5.};
    const PlateMeasure m = s.measure([&](double x, double z) {
      return (x > 10.3 && s.in_plate(x, z)) || (x > 10.8 && x < 13.6 && z > -8. && z < 6.5);
    });
    EXPECT_TRUE(m.perforated);
    EXPECT_NEAR(m.hole_diameter, 20.6, 0.2);
    EXPECT_NEAR(m.front_lip, 8., 0.1);
    EXPECT_NEAR(m.rear_bulge, 1.5, 0.1);
  }

  TEST(PlateMeasure, ShiftedAlongTheAxis)
  {
    const Scenery      s{Symmetry::axisymmetric, 64, 128, 5., 40.};
    const auto         shifted = [&](double x, double z) { return s.in_plate(x, z - 43.7); };
    const PlateMeasure whole   = s.measure(shifted);
    expect_whole(whole);
    EXPECT_NEAR(whole.crater_depth, 0., 0.02);
    const PlateMeasure m = s.measure([&](double x, double z) { return shifted(x, z) && std::hypot(x, z - 43.7) > 3.; });
    expect_whole(m);
    EXPECT_NEAR(m.crater_depth, 3., 0.2);
    EXPECT_NEAR(m.least_thickness, 2., 0.1);
  }

  TEST(PlateMeasure, TiltedPlate)
  {
    for (const double degrees : {5., 15., 30.})
      for (const double thickness : {2.5, 5.})
        {
          const double  angle = degrees * std::numbers::pi / 180., c = std::cos(angle), t = std::sin(angle);
          const Scenery s{Symmetry::planar, 96, 96, thickness, 40.};
          Scenery       full = s;
          full.half          = false;
          const auto along   = [=](double x, double z) { return c * x + t * z; };
          const auto turned  = [=](double x, double z) { return s.in_plate(along(x, z), c * z - t * x); };
          SCOPED_TRACE(testing::Message() << degrees << " degrees, " << thickness);
          const PlateMeasure whole = full.measure(turned);
          expect_whole(whole);
          EXPECT_NEAR(whole.crater_depth, 0., 0.15);
          EXPECT_NEAR(whole.least_thickness, thickness / c, 0.1);
          const PlateMeasure m = full.measure(
              [&](double x, double z) { return turned(x, z) && (along(x, z) < -3. || along(x, z) > 10.); });
          EXPECT_TRUE(m.perforated);
          EXPECT_NEAR(m.hole_diameter, 13., 0.3);
        }
  }

  TEST(PlateMeasure, SplitInTwoPieces)
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

  TEST(PlateMeasure, DebrisOfItsOwnDoesNotCloseTheHole)
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
  TEST(PlateMeasure, DistendedCloudInTheHoleBarsNothing)
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

  TEST(PlateMeasure, FragmentedRim)
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
          EXPECT_NEAR(m.least_thickness, 5., 0.05);
      }
  }

  TEST(PlateMeasure, ShatteredPlateIsAllHole)
  {
    const Scenery      s{Symmetry::planar, 96, 64, 5., 36., 0., false};
    const PlateMeasure m =
        s.measure([&](double x, double z) { return s.in_plate(x, z) && std::fmod(std::abs(x), 4.) > 1.6; });
    EXPECT_TRUE(m.perforated);
    EXPECT_EQ(m.hole_diameter, 72.);
    EXPECT_EQ(m.crater_depth, 5.);
    EXPECT_NEAR(m.detached_mass, 0.6 * 72. * 5., 1.);
  }

  TEST(PlateMeasure, LostRim)
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
  TEST(PlateMeasure, AnyCloudIsMeasured)
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

  TEST(PlateMeasure, CoarseCellsAmongFine)
  {
    for (const double front : {0., 0.3, 1.7})
      {
        const Scenery s{Symmetry::axisymmetric, 64, 64, 9., infinite, front};
        // fine around the hole, then twice and four times as large
        const auto size = [](int i, int) { return i < 24 ? 1 : i < 40 ? 2 : 4; };
        for (const double hole : {0., 8.3, 30.2, 44.7})
          {
            const auto m = measure_plate(
                s.site(), s.paint([&](double x, double z) { return s.in_plate(x, z) && x > hole; }, size));
            ASSERT_TRUE(m);
            EXPECT_EQ(m->perforated, hole > 0);
            EXPECT_NEAR(m->hole_diameter, 2. * hole, hole < 24. ? 0.2 : 0.4);
            EXPECT_NEAR(m->rear_bulge, 0., 0.05);
            EXPECT_NEAR(m->detached_mass, 0., 1e-6);
            if (hole == 0)
              EXPECT_NEAR(m->least_thickness, 9., 0.05);
          }
      }
  }

  TEST(PlateMeasure, WhatCannotBeSeenIsNotMeasured)
  {
    Scenery    s{Symmetry::axisymmetric, 64, 64, 0.4};
    const auto plate = [&](double x, double z) { return s.in_plate(x, z); };
    EXPECT_FALSE(measure_plate(s.site(), s.paint(plate))); // thinner than a cell
    s.thickness = 3.;
    EXPECT_FALSE(measure_plate(s.site(), s.paint(plate, [](int, int) { return 4; }))); // than those it lies in
    EXPECT_TRUE(measure_plate(s.site(), s.paint(plate)));
    EXPECT_FALSE(measure_plate(s.site(), {})); // gone
  }

  TEST(PlateMeasure, OrderOfCellsDoesNotMatter)
  {
    const Scenery          s{Symmetry::axisymmetric, 64, 64, 5.};
    std::vector<PlateCell> cells = s.paint(
        [&](double x, double z) { return s.in_plate(x, z) ? x > 9.3 + 0.2 * z : std::hypot(x - 5., z + 9.) < 3.; });
    const auto first = measure_plate(s.site(), cells);
    std::shuffle(cells.begin(), cells.end(), std::mt19937(3));
    const auto second = measure_plate(s.site(), cells);
    ASSERT_TRUE(first && second);
    EXPECT_EQ(first->hole_diameter, second->hole_diameter);
    EXPECT_EQ(first->smallest_hole_diameter, second->smallest_hole_diameter);
    EXPECT_EQ(first->detached_mass, second->detached_mass);
    EXPECT_EQ(first->rear_bulge, second->rear_bulge);
  }
} // namespace
