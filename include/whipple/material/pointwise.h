// SPDX-License-Identifier: LGPL-2.1-or-later
#pragma once

#include <span>

/// The kernels of an equation of state from its value at one state, for laws whose loops gain nothing from a form of
/// their own.
namespace whipple::pointwise
{
  /// Pressure [Mbar] with its derivatives along density at constant energy and along energy at constant density.
  struct Value
  {
    double pressure, dp_ddensity, dp_de;
  };

  /// EquationOfState::evaluate: c^2 = dP/dgamma + P / gamma^2 dP/de.
  /// @param value_at (gamma, energy) -> Value
  template <class ValueAt>
  void
  evaluate(const ValueAt &value_at, std::span<const double> true_density, std::span<const double> energy,
           std::span<double> pressure, std::span<double> sound_speed_squared)
  {
    const std::size_t n = true_density.size();
    for (std::size_t i = 0; i < n; ++i)
      {
        const Value p          = value_at(true_density[i], energy[i]);
        pressure[i]            = p.pressure;
        sound_speed_squared[i] = p.dp_ddensity + p.pressure / (true_density[i] * true_density[i]) * p.dp_de;
      }
  }

  /// EquationOfState::derivatives.
  template <class ValueAt>
  void
  derivatives(const ValueAt &value_at, std::span<const double> true_density, std::span<const double> energy,
              std::span<double> dp_ddensity, std::span<double> dp_de)
  {
    const std::size_t n = true_density.size();
    for (std::size_t i = 0; i < n; ++i)
      {
        const Value p  = value_at(true_density[i], energy[i]);
        dp_ddensity[i] = p.dp_ddensity;
        dp_de[i]       = p.dp_de;
      }
  }
} // namespace whipple::pointwise
