// SPDX-License-Identifier: LGPL-2.1-or-later
#pragma once

#include <whipple/material/equation_of_state.h>

namespace whipple
{
  /// Gamma-law gas, P = (k - 1) gamma e, with k the ratio of specific heats (k, because gamma is the true
  /// density everywhere in Whipple); c^2 = k P / gamma. See doc/theory/equation_of_state.md.
  class IdealGas : public EquationOfState
  {
  public:
    /// @param adiabatic_exponent k > 1.
    /// @param reference_density typical density [g/cm^3] of the gas in the scene, > 0.
    /// @throws InputError for values outside these ranges.
    IdealGas(double adiabatic_exponent, double reference_density);

    void
    evaluate(std::span<const double> true_density, std::span<const double> energy, std::span<double> pressure,
             std::span<double> sound_speed_squared) const override;
    void
    derivatives(std::span<const double> true_density, std::span<const double> energy, std::span<double> dp_ddensity,
                std::span<double> dp_de) const override;
    double
    energy_of_pressure(double true_density, double pressure) const override;
    double
    reference_density() const override;
    std::string
    name() const override;

  private:
    double exponent_minus_1;
    double reference_density_;
  };
} // namespace whipple
