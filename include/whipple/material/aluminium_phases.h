// SPDX-License-Identifier: LGPL-2.1-or-later
#pragma once

#include <whipple/material/helmholtz_phase.h>

#include <array>
#include <cmath>
#include <cstddef>

/// Free energies of solid and fluid aluminium, fitted to the Hugoniot, the melting point and the melt curve of the
/// ANEOS library of 1972 (doc/theory/equation_of_state.md, "Solid, liquid, vapour"). Energies from the unstressed solid
/// at 298 K; valid up to 3 gamma0.
namespace whipple::aluminium_phases
{
  constexpr double gas_constant          = 8.314462618e-5 / 26.9815385; ///< R [Mbar cm^3/(g K)]
  constexpr double specific_heat         = 3. * gas_constant;           ///< Dulong and Petit, in every phase
  constexpr double reference_density     = 2.70;                        ///< g/cm^3
  constexpr double reference_temperature = 298.;                        ///< K

  /// Polynomial in x and its two derivatives, by Horner's rule.
  template <std::size_t n>
  inline ColdEnergy
  polynomial(const std::array<double, n> &coefficient, double x)
  {
    double value = coefficient[n - 1], slope = 0., half_curvature = 0.;
    for (std::size_t k = n - 1; k-- > 0;)
      {
        half_curvature = half_curvature * x + slope;
        slope          = slope * x + value;
        value          = value * x + coefficient[k];
      }
    return {value, slope, 2. * half_curvature};
  }

  struct SolidConstants
  {
    static constexpr double reference_density     = aluminium_phases::reference_density;
    static constexpr double reference_temperature = aluminium_phases::reference_temperature;
    static constexpr double specific_heat         = aluminium_phases::specific_heat;
    static constexpr double entropy_shift         = 0.;

    static constexpr double grueneisen_reference = 2.040737954; ///< at gamma0
    static constexpr double grueneisen_limit     = 0.254699288; ///< far compressed

    /// In eta - 1; the first two make e = 0, P = 0 at gamma0 and 298 K.
    static constexpr std::array<double, 8> cold{-specific_heat * reference_temperature,
                                                -grueneisen_reference *specific_heat *reference_temperature,
                                                0.1464451597,
                                                -0.02645581189,
                                                -0.001334848644,
                                                -0.002291181845,
                                                0.006029262081,
                                                -0.001498333635};

    static ColdEnergy
    cold_energy(double eta)
    {
      return polynomial(cold, eta - 1.);
    }
    static GrueneisenCurve
    grueneisen(double eta)
    {
      constexpr double excess = grueneisen_reference - grueneisen_limit;
      return {grueneisen_limit + excess / eta, -excess / (eta * eta)};
    }
    static double
    log_theta(double eta)
    {
      return grueneisen_limit * std::log(eta) + (grueneisen_reference - grueneisen_limit) * (1. - 1. / eta);
    }
  };

  /// Liquid and vapour: one curve, an ideal gas (Gamma = R/C = 1/3) at low density.
  struct FluidConstants
  {
    static constexpr double reference_density     = aluminium_phases::reference_density;
    static constexpr double reference_temperature = aluminium_phases::reference_temperature;
    static constexpr double specific_heat         = aluminium_phases::specific_heat;
    static constexpr double entropy_shift         = 2.547251421e-05;

    /// Gamma = (1/3 + a eta + b eta^2) / (1 + c eta^2)
    static constexpr double a = 3.174185327, b = -0.8717205326, c = 0.3198003344;

    /// In eta; the first is the energy of the cold vapour.
    static constexpr std::array<double, 9> cold{0.121606066,   -0.04822128006, -0.6844183677,
                                                1.304887927,   -1.087682287,   0.5231612311,
                                                -0.1502096605, 0.02427300827,  -0.001703438072};

    static ColdEnergy
    cold_energy(double eta)
    {
      return polynomial(cold, eta);
    }
    static GrueneisenCurve
    grueneisen(double eta)
    {
      const double below = 1. / (1. + c * eta * eta);
      const double value = (1. / 3. + (a + b * eta) * eta) * below;
      return {value, (a + 2. * (b - c * value) * eta) * below};
    }
    static double
    log_theta(double eta)
    {
      const double root = std::sqrt(c);
      return std::log(eta) / 3. + a / root * std::atan(root * eta) +
             (b - c / 3.) / (2. * c) * std::log1p(c * eta * eta);
    }
  };

  using Solid = HelmholtzPhase<SolidConstants>;
  using Fluid = HelmholtzPhase<FluidConstants>;
} // namespace whipple::aluminium_phases
