// SPDX-License-Identifier: LGPL-2.1-or-later
#pragma once

#include <whipple/diagnostics/plate_measure.h>

#include <gtest/gtest.h>

#include <algorithm>
#include <cmath>
#include <functional>
#include <limits>
#include <numbers>
#include <vector>

/// Plates painted by formulas.
namespace whipple::plate_scenery
{
  inline constexpr double infinite = std::numeric_limits<double>::infinity();

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

  inline void
  expect_whole(const PlateMeasure &m)
  {
    EXPECT_FALSE(m.perforated);
    EXPECT_EQ(m.hole_diameter, 0.);
    EXPECT_EQ(m.smallest_hole_diameter, 0.);
    EXPECT_EQ(m.perforation_margin, -m.least_thickness);
  }
} // namespace whipple::plate_scenery
