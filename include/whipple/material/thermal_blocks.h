// SPDX-License-Identifier: LGPL-2.1-or-later
#pragma once

#include <whipple/material/thermal_model.h>

#include <algorithm>
#include <array>

namespace whipple
{
  struct ThermalPoint
  {
    double temperature, melt_temperature; ///< K
    double melt_fraction;
  };

  /// Call f(i, ThermalPoint) for every entry of the arrays: the thermal model runs over blocks on the stack, so that
  /// models which only use the temperature on the way keep no array of it.
  template <class F>
  void
  for_each_thermal_point(const ThermalModel &thermal, std::span<const double> density, std::span<const double> energy,
                         const F &f)
  {
    constexpr std::size_t          block_size = 256;
    std::array<double, block_size> temperature, melt_temperature, melt_fraction;
    const std::size_t              n = density.size();
    for (std::size_t first = 0; first < n; first += block_size)
      {
        const std::size_t size = std::min(block_size, n - first);
        thermal.evaluate(
            density.subspan(first, size), energy.subspan(first, size),
            {{temperature.data(), size}, {melt_temperature.data(), size}, {melt_fraction.data(), size}, {}});
        for (std::size_t i = 0; i < size; ++i)
          f(first + i, ThermalPoint{temperature[i], melt_temperature[i], melt_fraction[i]});
      }
  }
} // namespace whipple
