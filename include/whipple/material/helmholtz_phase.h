// SPDX-License-Identifier: LGPL-2.1-or-later
#pragma once

#include <cmath>

namespace whipple
{
  /// Cold energy phi and its derivatives by eta = gamma/gamma0 [Mbar cm^3/g].
  struct ColdEnergy
  {
    double value, slope, curvature;
  };

  /// Grueneisen coefficient and its derivative by eta.
  struct GrueneisenCurve
  {
    double value, slope;
  };

  /// One phase of a material, from its Helmholtz free energy
  ///
  ///   F = phi(eta) + C T [1 - ln(T/T0) + ln theta(eta)] - s0 T,   Gamma = d ln theta / d ln eta,
  ///
  /// so e = phi + C T, P = gamma0 eta^2 phi' + Gamma gamma (e - phi), S = C [ln(T/T0) - ln theta] + s0.
  ///
  /// @tparam Material what is its own: static constexpr reference_density, specific_heat, reference_temperature,
  /// entropy_shift, and static functions cold_energy(eta), grueneisen(eta), log_theta(eta).
  template <class Material>
  struct HelmholtzPhase : Material
  {
    /// P and its derivatives, and T, at (gamma, e).
    struct Caloric
    {
      double pressure, dp_ddensity, dp_de, temperature;
    };
    static Caloric
    caloric(double true_density, double energy)
    {
      const double          eta     = true_density / Material::reference_density;
      const ColdEnergy      phi     = Material::cold_energy(eta);
      const GrueneisenCurve g       = Material::grueneisen(eta);
      const double          thermal = energy - phi.value;
      return {Material::reference_density * eta * eta * phi.slope + g.value * true_density * thermal,
              eta * ((2. - g.value) * phi.slope + eta * phi.curvature) + (g.value + eta * g.slope) * thermal,
              g.value * true_density, thermal / Material::specific_heat};
    }

    /// P and its derivatives at (gamma, T).
    struct Thermal
    {
      double pressure, dp_ddensity, dp_dT;
    };
    static Thermal
    thermal(double true_density, double temperature)
    {
      const double          eta  = true_density / Material::reference_density;
      const ColdEnergy      phi  = Material::cold_energy(eta);
      const GrueneisenCurve g    = Material::grueneisen(eta);
      const double          heat = Material::specific_heat * temperature;
      return {Material::reference_density * eta * eta * phi.slope + g.value * true_density * heat,
              eta * (2. * phi.slope + eta * phi.curvature) + (g.value + eta * g.slope) * heat,
              g.value * true_density * Material::specific_heat};
    }

    static double
    temperature(double true_density, double energy)
    {
      return (energy - Material::cold_energy(true_density / Material::reference_density).value) /
             Material::specific_heat;
    }

    static double
    energy(double true_density, double temperature)
    {
      return Material::cold_energy(true_density / Material::reference_density).value +
             Material::specific_heat * temperature;
    }

    static double
    entropy(double true_density, double temperature)
    {
      return Material::specific_heat * (std::log(temperature / Material::reference_temperature) -
                                        Material::log_theta(true_density / Material::reference_density)) +
             Material::entropy_shift;
    }

    /// Gibbs' free energy.
    static double
    gibbs(double true_density, double temperature)
    {
      return energy(true_density, temperature) - temperature * entropy(true_density, temperature) +
             thermal(true_density, temperature).pressure / true_density;
    }
  };
} // namespace whipple
