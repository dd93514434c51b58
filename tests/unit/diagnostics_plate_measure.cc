// SPDX-License-Identifier: LGPL-2.1-or-later
// Holes and craters of plates painted by formulas, whose answers are known.
#include "plate_scenery.h"

#include <random>

namespace
{
  using namespace whipple;
  using namespace whipple::plate_scenery;

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
              {
                EXPECT_NEAR(m->least_thickness, 9., 0.05);
              }
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
