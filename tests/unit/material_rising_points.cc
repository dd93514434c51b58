// SPDX-License-Identifier: LGPL-2.1-or-later
#include <whipple/material/rising_points.h>

#include <gtest/gtest.h>

#include <algorithm>
#include <random>

namespace
{
  using whipple::rising_points;
  using Points = std::vector<std::size_t>;

  TEST(RisingPoints, TheFewestAreTakenOut)
  {
    EXPECT_EQ(rising_points(std::vector{1., 2., 3.}), (Points{0, 1, 2}));
    EXPECT_EQ(rising_points(std::vector{1., 9., 2., 3., 4.}), (Points{0, 2, 3, 4})); // one too high, not three too low
    EXPECT_EQ(rising_points(std::vector{5., 5., 5., 4., 6., 7.}).size(), 3u);
    EXPECT_EQ(rising_points(std::vector{3., 2., 1.}).size(), 1u);
    EXPECT_EQ(rising_points(std::vector{-1., -1. + 1e-9, -0.5, 0., 0., 1e-30}),
              (Points{0, 2, 4, 5})); // of equal ones the last
    EXPECT_TRUE(rising_points(std::vector<double>{}).empty());
  }

  /// Length of the longest rising subsequence, by trying all.
  int
  longest(const std::vector<double> &values)
  {
    int best = 0;
    for (unsigned chosen = 0; chosen < 1u << values.size(); ++chosen)
      {
        double last  = -1e300;
        int    count = 0;
        for (std::size_t k = 0; k < values.size() && count >= 0; ++k)
          if (chosen >> k & 1)
            {
              count = values[k] > last ? count + 1 : -1;
              last  = values[k];
            }
        best = std::max(best, count);
      }
    return best;
  }

  TEST(RisingPoints, AsManyAsPossibleAndRising)
  {
    std::mt19937 generator(7);
    for (int trial = 0; trial < 100; ++trial)
      {
        std::vector<double> values(10);
        for (double &value : values)
          value = static_cast<double>(generator() % 12);
        const Points points = rising_points(values);
        EXPECT_EQ(static_cast<int>(points.size()), longest(values));
        for (std::size_t k = 1; k < points.size(); ++k)
          EXPECT_GT(values[points[k]], values[points[k - 1]]);
      }
  }
} // namespace
