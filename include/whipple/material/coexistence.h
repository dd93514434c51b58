// SPDX-License-Identifier: LGPL-2.1-or-later
#pragma once

#include <whipple/error.h>
#include <whipple/material/helmholtz_phase.h>
#include <whipple/material/hermite_table.h>

#include <algorithm>
#include <cmath>
#include <string>
#include <utility>

namespace whipple
{
  /// Densities of two phases in equilibrium at a temperature: equal pressure and Gibbs energy, by Newton's method from
  /// the densities given.
  /// @throws StateError if it does not converge.
  template <class Dense, class Light>
  void
  equilibrate(double temperature, double &dense, double &light)
  {
    double change = 1.;
    for (int iteration = 0; iteration < 100 && change > 1e-14; ++iteration)
      {
        const auto   a          = Dense::thermal(dense, temperature);
        const auto   b          = Light::thermal(light, temperature);
        const double pressure   = a.pressure - b.pressure;
        const double gibbs      = Dense::gibbs(dense, temperature) - Light::gibbs(light, temperature);
        const double light_rise = (pressure / dense - gibbs) / (1. / dense - 1. / light); // of its pressure
        const double dense_part = std::clamp((light_rise - pressure) / (a.dp_ddensity * dense), -0.05, 0.05);
        const double light_part = std::clamp(light_rise / (b.dp_ddensity * light), -0.5, 0.5);
        dense *= 1. + dense_part;
        light *= std::exp(light_part); // vapour: over many decades
        change = std::max(std::abs(dense_part), std::abs(light_part));
      }
    if (!(change < 1e-6)) // near the critical point rounding is left
      throw StateError("no equilibrium of phases at " + std::to_string(temperature) + " K, densities " +
                       std::to_string(dense) + " and " + std::to_string(light) + " g/cm^3");
  }

  /// Two phases of a material (HelmholtzPhase) side by side: their densities along the curve of equilibrium, tables
  /// over a parameter tau, and the mixture at (v, e) by the lever rule. What is returned is differentiable and its
  /// derivatives are exact; that P and the Gibbs energies of both phases agree holds to the error of the tables.
  template <class Dense, class Light>
  class Coexistence
  {
  public:
    /// What tau is: the temperature itself, or sqrt(1 - T/T_critical), in which densities are smooth up to the
    /// critical point. In the latter case the table of the light phase holds ln(density).
    enum class Parameter
    {
      temperature,
      critical_distance
    };

    Coexistence(Parameter parameter, double critical_temperature, HermiteTable dense, HermiteTable light)
      : parameter_(parameter)
      , critical_temperature_(critical_temperature)
      , dense_(std::move(dense))
      , light_(std::move(light))
    {
    }

    double
    first() const
    {
      return dense_.first();
    }
    double
    last() const
    {
      return dense_.last();
    }

    /// With Parameter::critical_distance.
    double
    critical_temperature() const
    {
      return critical_temperature_;
    }

    double
    parameter(double temperature) const
    {
      return parameter_ == Parameter::temperature ? temperature : std::sqrt(1. - temperature / critical_temperature_);
    }

    double
    dense_density(double tau) const
    {
      return dense_(tau).value;
    }
    double
    light_density(double tau) const
    {
      return light(tau).value;
    }

    /// Both ends of a tie line, and the derivatives of all by tau.
    struct TieLine
    {
      double              temperature, temperature_slope;
      HermiteTable::Value dense_volume, light_volume, dense_energy, light_energy;
      double              pressure, pressure_slope;
    };

    TieLine
    tie_line(double tau) const
    {
      const bool   critical    = parameter_ == Parameter::critical_distance;
      const double temperature = critical ? critical_temperature_ * (1. - tau * tau) : tau;
      const double slope       = critical ? -2. * critical_temperature_ * tau : 1.;
      const auto   a = dense_(tau), b = light(tau);
      const auto   p      = Light::thermal(b.value, temperature);
      const auto   volume = [](const HermiteTable::Value &density) {
        return HermiteTable::Value{1. / density.value, -density.slope / (density.value * density.value)};
      };
      return {temperature,
              slope,
              volume(a),
              volume(b),
              energy<Dense>(a, temperature, slope),
              energy<Light>(b, temperature, slope),
              p.pressure,
              p.dp_ddensity * b.slope + p.dp_dT * slope};
    }

    struct Mixture
    {
      double tau, pressure, dp_ddensity, dp_de, temperature, light_fraction;
    };

    /// The mixture of density gamma and energy e, with tau between the bounds.
    Mixture
    mixture(double true_density, double energy, double lower, double upper) const
    {
      const double v       = 1. / true_density;
      const bool   rising  = parameter_ == Parameter::temperature; // the energy, with tau
      double       tau     = 0.5 * (lower + upper);
      Excess       at_root = excess(tau, v, energy);
      for (int iteration = 0; iteration < 200; ++iteration)
        {
          if (at_root.value == 0.)
            break;
          ((at_root.value < 0.) == rising ? lower : upper) = tau;
          const double newton                              = tau - at_root.value / at_root.by_tau;
          const double next = newton > lower && newton < upper ? newton : 0.5 * (lower + upper);
          const bool   done = std::abs(next - tau) <= 4e-16 * std::abs(tau);
          tau               = next;
          at_root           = excess(tau, v, energy);
          if (done)
            break;
        }
      const TieLine &line  = at_root.line;
      const double   by_v  = at_root.by_v / at_root.by_tau; // -dtau/dv at constant e
      const double   share = (v - line.dense_volume.value) / (line.light_volume.value - line.dense_volume.value);
      return {tau,
              line.pressure,
              line.pressure_slope * by_v * v * v,
              line.pressure_slope / at_root.by_tau,
              line.temperature,
              share};
    }

  private:
    HermiteTable::Value
    light(double tau) const
    {
      const HermiteTable::Value table = light_(tau);
      if (parameter_ == Parameter::temperature)
        return table;
      const double density = std::exp(table.value);
      return {density, density * table.slope};
    }

    template <class Phase>
    static HermiteTable::Value
    energy(const HermiteTable::Value &density, double temperature, double temperature_slope)
    {
      const ColdEnergy phi = Phase::cold_energy(density.value / Phase::reference_density);
      return {phi.value + Phase::specific_heat * temperature,
              phi.slope * density.slope / Phase::reference_density + Phase::specific_heat * temperature_slope};
    }

    /// Energy of the mixture of volume v on the tie line of tau, less e; and its derivatives.
    struct Excess
    {
      TieLine line;
      double  value, by_tau;
      double  by_v;
    };
    Excess
    excess(double tau, double v, double e) const
    {
      const TieLine line        = tie_line(tau);
      const double  dv          = line.light_volume.value - line.dense_volume.value;
      const double  ratio       = (line.light_energy.value - line.dense_energy.value) / dv;
      const double  ratio_slope = (line.light_energy.slope - line.dense_energy.slope -
                                  ratio * (line.light_volume.slope - line.dense_volume.slope)) /
                                 dv;
      const double part = v - line.dense_volume.value;
      return {line, line.dense_energy.value + part * ratio - e,
              line.dense_energy.slope - line.dense_volume.slope * ratio + part * ratio_slope, ratio};
    }

    Parameter    parameter_;
    double       critical_temperature_;
    HermiteTable dense_, light_;
  };
} // namespace whipple
