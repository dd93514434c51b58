// SPDX-License-Identifier: LGPL-2.1-or-later
#pragma once

#include <whipple/material/equation_of_state.h>

namespace whipple
{
  /// Stiffened gas with its energy counted from the unstressed state,
  ///
  ///   P = c0^2 (gamma - gamma0) + (k - 1) gamma e,   c^2 = c0^2 + (k - 1) (e + P / gamma).
  ///
  /// The textbook form P = (k - 1) gamma e' - k P_inf is the same law with k P_inf = gamma0 c0^2 and
  /// e' = e + c0^2 / (k - 1). See doc/theory/equation_of_state.md.
  class StiffenedGas : public EquationOfState
  {
  public:
    struct Constants
    {
      double reference_density  = 0; ///< gamma0 [g/cm^3], > 0: density at P = 0, e = 0
      double sound_speed        = 0; ///< c0 [cm/us], > 0
      double adiabatic_exponent = 0; ///< k > 1
    };

    /// @throws InputError for constants outside their ranges.
    explicit StiffenedGas(const Constants &constants);

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
    Constants constants;
  };
} // namespace whipple
