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

  /// Matter parts where it is stretched beyond what any bond bears, whether or not a void law has had the time to open
  /// pores: tension fades between 0.85 and 0.7 of the reference density, P -> P S((gamma/gamma0 - 0.7) / 0.15), S = 3
  /// x^2
  /// - 2 x^3. Without that a thin tail of a metal pulls with some 0.3 Mbar (doc/theory/voids.md).
  /// @param density true density gamma, g/cm^3   @param pressure of the bulk or the solid
  inline void
  part_in_tension(const std::vector<double> &density, double reference, std::vector<double> &pressure)
  {
    constexpr double  parted = 0.7, width = 0.15;
    const double      scale = 1. / (width * reference);
    const std::size_t n     = pressure.size();
    for (std::size_t c = 0; c < n; ++c)
      {
        const double x = (density[c] - parted * reference) * scale, y = x < 0. ? 0. : x > 1. ? 1. : x;
        const double kept = y * y * (3. - 2. * y);
        pressure[c] *= pressure[c] < 0. ? kept : 1.;
      }
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
