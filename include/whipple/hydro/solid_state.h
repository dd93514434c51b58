// SPDX-License-Identifier: LGPL-2.1-or-later
#pragma once

#include <vector>

/// The solid behind the pores, for models that know it only: batches over all cells. `void_fraction` is empty where the
/// material has no pores.
namespace whipple::solid_state
{
  /// gamma = rho / (1 - phi), g/cm^3; the reference density where there is nothing.
  inline void
  true_density(const std::vector<double> &density, const std::vector<double> &void_fraction, double reference,
               std::vector<double> &result)
  {
    const std::size_t n = density.size();
    if (void_fraction.empty())
      for (std::size_t c = 0; c < n; ++c)
        result[c] = density[c] > 0 ? density[c] : reference;
    else
      for (std::size_t c = 0; c < n; ++c)
        result[c] = density[c] > 0 ? density[c] / (1. - void_fraction[c]) : reference;
  }

  /// P_s = P / (1 - phi), Mbar.
  inline void
  pressure(const std::vector<double> &bulk, const std::vector<double> &void_fraction, std::vector<double> &result)
  {
    const std::size_t n = bulk.size();
    for (std::size_t c = 0; c < n; ++c)
      result[c] = void_fraction.empty() ? bulk[c] : bulk[c] / (1. - void_fraction[c]);
  }
} // namespace whipple::solid_state
