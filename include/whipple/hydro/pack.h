// SPDX-License-Identifier: LGPL-2.1-or-later
#pragma once

#include <whipple/mesh/index.h>

#include <algorithm>
#include <cmath>
#pragma GCC diagnostic push
#pragma GCC diagnostic ignored "-Wuninitialized" // false alarms of GCC 12 in its own intrinsics
#pragma GCC diagnostic ignored "-Wmaybe-uninitialized"
#include <experimental/simd>
#pragma GCC diagnostic pop
#include <vector>

/// Several cells at a time: kernels are written once for a number type that is either double or a Pack.
/// Every lane does the same IEEE operations as the scalar code, so no value depends on its place in an array.
namespace whipple
{
  /// As many doubles as one register of the machine holds.
  using Pack = std::experimental::native_simd<double>;

  /// Cells in a pack.
  inline constexpr Index pack_size = static_cast<Index>(Pack::size());

  /// condition ? a : b
  inline double
  select(bool condition, double a, double b)
  {
    return condition ? a : b;
  }

  /// condition ? a : b, lane by lane.
  inline Pack
  select(const Pack::mask_type &condition, const Pack &a, Pack b)
  {
    where(condition, b) = a;
    return b;
  }

  /// Number of packs that n cells need.
  inline Index
  pack_count(Index n)
  {
    return (n + pack_size - 1) / pack_size;
  }

  /// Values first, first + 1, ... of an array; lanes past its end repeat the last value.
  inline Pack
  load(const std::vector<double> &array, Index first)
  {
    const Index n = static_cast<Index>(array.size());
    if (first + pack_size <= n)
      return Pack(&array[first], std::experimental::element_aligned);
    return Pack([&](auto lane) { return array[std::min<Index>(first + static_cast<Index>(lane), n - 1)]; });
  }

  /// Inverse of load(); lanes past the end of the array are dropped.
  inline void
  store(const Pack &value, std::vector<double> &array, Index first)
  {
    const Index n = static_cast<Index>(array.size());
    if (first + pack_size <= n)
      value.copy_to(&array[first], std::experimental::element_aligned);
    else
      for (Index lane = 0; first + lane < n; ++lane)
        array[first + lane] = value[lane];
  }

  /// True in the lanes that belong to cells below `end`.
  inline Pack::mask_type
  lanes_below(Index first, Index end)
  {
    return Pack([&](auto lane) { return static_cast<double>(first + static_cast<Index>(lane)); }) <
           Pack(static_cast<double>(end));
  }
} // namespace whipple
