// SPDX-License-Identifier: LGPL-2.1-or-later
#pragma once

#include <whipple/material/equation_of_state.h>

namespace whipple
{
  /// Tillotson's law for hypervelocity impact: a condensed branch and a vapour branch, with eta = gamma/gamma0,
  /// mu = eta - 1, z = 1/eta - 1 and w = 1 + |e|/(E0 eta^2):
  ///
  ///   P1 = (a + b/w) gamma e + A mu + B mu^2    in compression, A mu / (1 - mu B/A) for the last two terms else,
  ///   P2 = a gamma e + [b gamma e / w + A mu exp(-beta z)] exp(-alpha z^2),
  ///   P  = P1                                   for eta >= 1, and for e <= E_iv,
  ///   P  = (1 - S) P1 + S P2                    for eta < 1, e > E_iv,
  ///
  /// S = t^2 (3 - 2t), t = (e - E_iv)/(E_cv - E_iv) cut to 0 ... 1. P is continuously differentiable everywhere, so
  /// c^2 has no jump: P1 and P2 share value and both derivatives at eta = 1, and the smooth S replaces the linear
  /// weight of the original, whose dP/de jumps at E_iv and E_cv. In expansion the original A mu + B mu^2 has a minimum
  /// at mu = -A/(2B) and pushes again below -A/B (eta = 0.84 in water); the quotient has its value, slope and
  /// curvature at gamma0 and is monotone. |e| in w keeps the pole at e = -E0 eta^2 out of cold tension. P is monotone
  /// in gamma for e <= E_iv (down to -A / (gamma0 (a + b)) at least); hotter expanded material need not be.
  /// doc/theory/equation_of_state.md.
  class Tillotson : public EquationOfState
  {
  public:
    struct Constants
    {
      double reference_density             = 0; ///< gamma0 [g/cm^3], > 0
      double hot_grueneisen                = 0; ///< a > 0: k - 1 of the vapour
      double cold_grueneisen               = 0; ///< b >= 0: what the cold solid has more than a
      double bulk_modulus                  = 0; ///< A [Mbar], > 0
      double quadratic_modulus             = 0; ///< B [Mbar], >= 0
      double reference_energy              = 0; ///< E0 [Mbar cm^3/g], > 0: where Gamma falls from a + b to a
      double thermal_decay                 = 0; ///< alpha >= 0
      double cohesive_decay                = 0; ///< beta >= 0
      double incipient_vaporisation_energy = 0; ///< E_iv [Mbar cm^3/g], > 0
      double complete_vaporisation_energy  = 0; ///< E_cv [Mbar cm^3/g], > E_iv
    };

    /// @throws InputError for constants outside their ranges.
    explicit Tillotson(const Constants &constants);

    void
    evaluate(std::span<const double> true_density, std::span<const double> energy, std::span<double> pressure,
             std::span<double> sound_speed_squared) const override;
    void
    derivatives(std::span<const double> true_density, std::span<const double> energy, std::span<double> dp_ddensity,
                std::span<double> dp_de) const override;

    /// Where P is not monotone in e (the joint of E_iv ... E_cv in some materials), one of the solutions.
    double
    energy_of_pressure(double true_density, double pressure) const override;
    double
    reference_density() const override;
    std::string
    name() const override;

  private:
    struct Value
    {
      double pressure, dp_ddensity, dp_de;
    };

    /// P1: no exponentials, for vector loops.
    Value
    condensed(double true_density, double energy) const;

    /// Whether vapour has a share in the pressure.
    bool
    has_vapour(double true_density, double energy) const
    {
      return true_density < constants.reference_density && energy > constants.incipient_vaporisation_energy;
    }

    /// (1 - S) P1 + S P2.
    Value
    expanded(double true_density, double energy) const;

    Constants constants;
  };
} // namespace whipple
