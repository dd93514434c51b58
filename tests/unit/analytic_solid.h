// SPDX-License-Identifier: LGPL-2.1-or-later
#pragma once

#include "equation_of_state_check.h"

#include <whipple/material/tabulated.h>

#include <algorithm>
#include <cmath>
#include <random>
#include <vector>

/// A law to make tables of, and how far a table is from it.
namespace whipple::analytic_solid
{
  /// A solid with temperature that is thermodynamically consistent and bends in every direction: Murnaghan's cold
  /// curve, a constant specific heat with Gamma constant, and electrons with a specific heat a T and Gamma_e = 1/2.
  /// Written from F = e_c(rho) + (lattice: C = C_v, p = Gamma rho e) + (electrons: e = a T^2 / 2 (rho0/rho)^(1/2), p =
  /// rho e / 2).
  struct Solid
  {
    static constexpr double rho0 = 2.7, bulk_modulus = 0.76, exponent = 4., heat = 9e-6, gruneisen = 2.1,
                            electrons = 2e-9;

    static double
    cold_pressure(double rho)
    {
      return bulk_modulus / exponent * (std::pow(rho / rho0, exponent) - 1.);
    }
    static double
    cold_energy(double rho)
    {
      const double x = rho / rho0;
      return bulk_modulus / (exponent * rho0) * ((std::pow(x, exponent - 1.) - 1.) / (exponent - 1.) + 1. / x - 1.);
    }
    static double
    electron_energy(double rho, double t)
    {
      return 0.5 * electrons * t * t * std::sqrt(rho0 / rho);
    }
    static double
    energy(double rho, double t)
    {
      return cold_energy(rho) + heat * t + electron_energy(rho, t);
    }
    static double
    pressure(double rho, double t)
    {
      return cold_pressure(rho) + rho * (gruneisen * heat * t + 0.5 * electron_energy(rho, t));
    }
    static double
    temperature(double rho, double e)
    {
      const double a = electrons * std::sqrt(rho0 / rho), thermal = e - cold_energy(rho);
      return 2. * thermal / (heat + std::sqrt(heat * heat + 2. * a * thermal));
    }
    static double
    pressure_of_energy(double rho, double e)
    {
      return pressure(rho, temperature(rho, e));
    }
    /// c^2 by differences of fourth order.
    static double
    sound_speed_squared(double rho, double e)
    {
      const auto by_rho = [&](double r) { return pressure_of_energy(r, e); };
      const auto by_e   = [&](double x) { return pressure_of_energy(rho, x); };
      return eos_check::slope(by_rho, rho, 1e-3 * rho) +
             pressure_of_energy(rho, e) / (rho * rho) * eos_check::slope(by_e, e, 1e-4);
    }
  };

  /// Shocked, released, expanded and hot states inside of the table, energies from Solid's zero.
  inline std::vector<eos_check::State>
  states(int count)
  {
    std::mt19937                           generator(3);
    std::uniform_real_distribution<double> uniform(0., 1.);
    std::vector<eos_check::State>          result;
    for (int i = 0; i < count; ++i)
      {
        const double rho = 1.6 + 4.2 * uniform(generator), t = 200. + 15000. * std::pow(uniform(generator), 2);
        result.push_back({rho, Solid::energy(rho, t)});
      }
    return result;
  }
  /// Largest relative errors of a table of the law; that of P relative to bulk modulus + |P|.
  struct Errors
  {
    double p = 0, c2 = 0, t = 0;
  };

  /// @param zero energy that the table counts as zero
  inline Errors
  errors(const Tabulated &law, double zero)
  {
    Errors worst;
    for (const auto &[rho, e] : states(2000))
      {
        const double shifted = e - zero, p = Solid::pressure_of_energy(rho, e);
        double       t = 0;
        law.evaluate({&rho, 1}, {&shifted, 1}, ThermalOutput{{&t, 1}, {}, {}, {}});
        const double off_p = eos_check::pressure(law, rho, shifted) - p;
        const double off_c2 =
            eos_check::sound_speed_squared(law, rho, shifted) / Solid::sound_speed_squared(rho, e) - 1.;
        worst.p  = std::max(worst.p, std::abs(off_p) / (Solid::bulk_modulus + std::abs(p)));
        worst.c2 = std::max(worst.c2, std::abs(off_c2));
        worst.t  = std::max(worst.t, std::abs(t / Solid::temperature(rho, e) - 1.));
      }
    return worst;
  }
} // namespace whipple::analytic_solid
