// SPDX-License-Identifier: LGPL-2.1-or-later
#pragma once

#include <whipple/material/equation_of_state.h>
#include <whipple/material/pointwise.h>
#include <whipple/material/reference_curve.h>

namespace whipple
{
  /// Mie-Grueneisen law about the cubic Hugoniot U_s = c0 + s1 u + s2 u^2/U_s + s3 u^3/U_s^2, with
  /// Gamma gamma = (Gamma0 + b mu) gamma0. With chi = 1 - gamma0/gamma = u/U_s and D = 1 - s1 chi - s2 chi^2 - s3
  /// chi^3:
  ///
  ///   P = P_H (1 - (Gamma0 + b mu) chi / 2) + (Gamma0 + b mu) gamma0 e,   P_H = gamma0 c0^2 chi / D^2,   mu >= 0,
  ///
  /// and in expansion as MieGrueneisen, with the same (Gamma0 + b mu) gamma0 e: P and c^2 are continuous at gamma0.
  /// s2 = s3 = b = 0 is MieGrueneisen. doc/theory/equation_of_state.md.
  class CubicMieGrueneisen : public EquationOfState
  {
  public:
    struct Constants
    {
      double        reference_density = 0;         ///< gamma0 [g/cm^3], > 0
      double        sound_speed       = 0;         ///< c0 [cm/us], > 0
      CubicHugoniot hugoniot          = {0, 0, 0}; ///< s1 >= 0, s2, s3
      double        grueneisen        = 0;         ///< Gamma0 > 0
      double        grueneisen_slope  = 0;         ///< b, 0 <= b < Gamma0: Gamma stays positive in expansion
    };

    /// @throws InputError for constants outside their ranges.
    explicit CubicMieGrueneisen(const Constants &constants);

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

    /// gamma0 / (1 - chi) at the smallest chi where D = 0 and the Hugoniot pressure is infinite, or where dP_H/dchi = 0
    /// and the fit has come to its end; infinite if there is neither below chi = 1.
    double
    max_density() const override;
    std::string
    name() const override;

  private:
    using Value = pointwise::Value;
    Value
    value(double true_density, double energy) const;

    Constants constants;
    double    density_limit;
  };
} // namespace whipple
