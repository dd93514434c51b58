// SPDX-License-Identifier: LGPL-2.1-or-later
#pragma once

#include <whipple/material/equation_of_state.h>

namespace whipple
{
  /// Mie-Grueneisen law about the Hugoniot U_s = c0 + s u_p, with Gamma gamma = Gamma0 gamma0. With
  /// K = gamma0 c0^2, chi = 1 - gamma0/gamma, mu = gamma/gamma0 - 1:
  ///
  ///   P = K chi (1 - Gamma0 chi / 2) / (1 - s chi)^2 + Gamma0 gamma0 e    in compression, mu >= 0,
  ///   P = K mu (1 + mu^2 gamma0 / gamma)             + Gamma0 gamma0 e    in expansion,   mu < 0.
  ///
  /// P and c^2 are continuous at gamma0 for every e. The expansion branch is the usual linear law K mu with
  /// a cubic term that matters only far out: it makes P -> -infinity as gamma -> 0, so that P = 0 has a
  /// solution however hot the material is (the void law needs one; the linear law leaves a finite pressure
  /// in the vacuum once e > c0^2 / Gamma0, 1.5 MJ/kg in lead). doc/theory/equation_of_state.md.
  class MieGrueneisen : public EquationOfState
  {
  public:
    struct Constants
    {
      double reference_density = 0; ///< gamma0 [g/cm^3], > 0
      double sound_speed       = 0; ///< c0 [cm/us], > 0: bulk sound speed
      double hugoniot_slope    = 0; ///< s >= 0
      double grueneisen        = 0; ///< Gamma0 > 0 at gamma0
    };

    /// @throws InputError for constants outside their ranges.
    explicit MieGrueneisen(const Constants &constants);

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

    /// gamma0 s / (s - 1), where chi = 1/s and the Hugoniot pressure is infinite; infinite for s <= 1.
    double
    max_density() const override;
    std::string
    name() const override;

  private:
    Constants constants;
  };
} // namespace whipple
