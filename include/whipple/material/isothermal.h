// SPDX-License-Identifier: LGPL-2.1-or-later
#pragma once

#include <whipple/material/equation_of_state.h>

#include <memory>

namespace whipple
{
  /// Any law with its energy term switched off, P = P_s(gamma, 0) and c^2 = dP_s/dgamma: the isothermal model
  /// of the 1993 paper. The energy of the cell is still booked by the solver; it just does not act.
  class IsothermalEquationOfState : public EquationOfState
  {
  public:
    /// @throws InputError if law is null, or unstressed at no density (a gas: P_s(gamma, 0) = 0 everywhere).
    explicit IsothermalEquationOfState(std::shared_ptr<const EquationOfState> law);

    void
    evaluate(std::span<const double> true_density, std::span<const double> energy, std::span<double> pressure,
             std::span<double> sound_speed_squared) const override;
    void
    derivatives(std::span<const double> true_density, std::span<const double> energy, std::span<double> dp_ddensity,
                std::span<double> dp_de) const override;

    /// 0 where P_s(gamma, 0) is the pressure asked for to 1e-12 of the reference bulk modulus.
    /// @throws StateError elsewhere: the energy cannot set the pressure.
    double
    energy_of_pressure(double true_density, double pressure) const override;
    double
    reference_density() const override;
    double
    max_density() const override;

    /// Name of the law inside.
    std::string
    name() const override;

  private:
    std::shared_ptr<const EquationOfState> law;
  };
} // namespace whipple
