// SPDX-License-Identifier: LGPL-2.1-or-later
#pragma once

#include <cstddef>
#include <span>
#include <vector>

namespace whipple
{
  /// Rise, relative to the values, below which two values of a table count as the same: ten units of the last of the
  /// nine digits that tables are printed with.
  inline constexpr double table_rounding = 1e-7;

  /// Indices of the points of a row that are left when the fewest are taken out such that the others rise strictly (the
  /// longest rising subsequence), and then those that rise above the one before by less than `table_rounding` of
  /// the larger size of both: what lies below the last digits of a table has slopes of noise.
  std::vector<std::size_t>
  rising_points(std::span<const double> values);
} // namespace whipple
