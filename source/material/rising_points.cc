// SPDX-License-Identifier: LGPL-2.1-or-later
#include <whipple/material/rising_points.h>

#include <algorithm>
#include <cmath>

namespace whipple
{
  namespace
  {
    /// Patience sorting: best[l] is the index of the smallest value that ends a rising subsequence of l + 1 points.
    std::vector<std::size_t>
    longest_rising(std::span<const double> values)
    {
      constexpr auto           none = static_cast<std::size_t>(-1);
      std::vector<std::size_t> best, before(values.size(), none);
      for (std::size_t k = 0; k < values.size(); ++k)
        {
          const auto at = std::lower_bound(best.begin(), best.end(), values[k],
                                           [&](std::size_t i, double value) { return values[i] < value; });
          before[k]     = at == best.begin() ? none : *(at - 1);
          if (at == best.end())
            best.push_back(k);
          else
            *at = k;
        }
      std::vector<std::size_t> points;
      for (std::size_t k = best.empty() ? none : best.back(); k != none; k = before[k])
        points.push_back(k);
      std::reverse(points.begin(), points.end());
      return points;
    }
  } // namespace

  std::vector<std::size_t>
  rising_points(std::span<const double> values)
  {
    std::vector<std::size_t> points;
    for (const std::size_t k : longest_rising(values))
      {
        const double last = points.empty() ? 0. : values[points.back()];
        if (points.empty() || values[k] - last > table_rounding * std::max(std::abs(values[k]), std::abs(last)))
          points.push_back(k);
      }
    return points;
  }
} // namespace whipple
