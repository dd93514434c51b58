// SPDX-License-Identifier: LGPL-2.1-or-later
#pragma once

#include <whipple/material/equation_of_state.h>
#include <whipple/material/mie_grueneisen.h>

namespace whipple
{
  /// The polynomial law of the 1993 paper (its (8b), DYNA's form 1), with mu = gamma/gamma0 - 1 and
  /// E = gamma0 e [Mbar] the energy per reference volume:
  ///
  ///   P = c1 mu + c2 max(mu, 0)^2 + c3 mu^3 + (c4 + c5 mu + c6 max(mu, 0)^2) E.
  ///
  /// See doc/theory/equation_of_state.md.
  class LinearPolynomial : public EquationOfState
  {
  public:
    struct Constants
    {
      double reference_density = 0; ///< gamma0 [g/cm^3], > 0
      double c1                = 0; ///< bulk modulus [Mbar], > 0; the 1993 aluminium: 0.652
      double c2                = 0; ///< [Mbar]
      double c3                = 0; ///< [Mbar]
      double c4                = 0; ///< Grueneisen coefficient at gamma0
      double c5                = 0;
      double c6                = 0;
    };

    /// Expansion of a Mie-Grueneisen law about gamma0, in mu to third order, with Gamma gamma constant:
    /// c1 = K, c2 = K (2 s - 1 - Gamma0/2), c3 = K (s - 1) (3 s - 1 - Gamma0), c4 = Gamma0, c5 = c6 = 0.
    static Constants
    expansion_of(const MieGrueneisen::Constants &law);

    /// @throws InputError unless gamma0 and c1 are positive and the rest is finite.
    explicit LinearPolynomial(const Constants &constants);

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
