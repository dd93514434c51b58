// SPDX-License-Identifier: LGPL-2.1-or-later
// Aluminium that melts and boils, against the tables of the ANEOS library of 1972; phases, Maxwell's relation, contract
// of an equation of state.
#include "equation_of_state_check.h"

#include <whipple/error.h>
#include <whipple/material/material_factory.h>
#include <whipple/material/solid_liquid_vapour.h>
#include <whipple/material/void_relaxation.h>

#include <limits>

namespace whipple
{
  namespace
  {
    using namespace eos_check;

    constexpr double eV = 11604.518; // in K

    const SolidLiquidVapour &
    metal()
    {
      static const SolidLiquidVapour model;
      return model;
    }

    struct Thermal
    {
      double temperature, melt_temperature, melt_fraction, vapour_fraction;
    };

    Thermal
    thermal(double true_density, double e)
    {
      Thermal t;
      metal().evaluate(
          {&true_density, 1}, {&e, 1},
          ThermalOutput{{&t.temperature, 1}, {&t.melt_temperature, 1}, {&t.melt_fraction, 1}, {&t.vapour_fraction, 1}});
      return t;
    }

    /// Density behind a shock of particle speed u into the reference state.
    double
    shocked_density(double u)
    {
      double lower = 2.7 * (1. + 1e-9), upper = 8.;
      for (int i = 0; i < 200; ++i)
        {
          const double true_density = 0.5 * (lower + upper);
          const double shock        = 2.7 * u * u / (1. - 2.7 / true_density);
          (pressure(metal(), true_density, 0.5 * u * u) < shock ? lower : upper) = true_density;
        }
      return lower;
    }

    /// Shocked, released, molten under pressure and at none, boiling, vapour, supercritical, in tension and nearly
    /// void; none within a difference step of the beginning or end of a phase.
    const std::vector<State> solid_states{{2.71, 1e-4}, {3.0, 0.008}, {3.6, 0.02}, {4.03, 0.054},
                                          {4.6, 0.13},  {5.5, 0.2},   {2.6, 0.006}};
    const std::vector<State> melting_states{{2.5, 0.0085}, {2.6, 0.0095}, {3.0, 0.0215}, {3.5, 0.0475}, {4.7, 0.152}};
    const std::vector<State> fluid_states{{2.4, 0.014}, {3.0, 0.04}, {4.7, 0.17}, {2.0, 0.06},
                                          {1.2, 0.15},  {0.5, 0.2},  {0.05, 0.18}};
    const std::vector<State> boiling_states{{0.9, 0.11}, {0.5, 0.12}, {0.3, 0.14}, {0.1, 0.135}, {0.05, 0.1602}};
    const std::vector<State> tension_states{{2.68, 0.},   {2.3, 0.004}, {2.4, 0.009}, {2.0, 0.012}, {1.4, 0.025},
                                            {1.2, 0.045}, {0.5, 0.07},  {0.2, 0.009}, {1e-3, 0.02}};

    std::vector<State>
    all_states()
    {
      std::vector<State> result;
      for (const auto &group : {solid_states, melting_states, fluid_states, boiling_states, tension_states})
        result.insert(result.end(), group.begin(), group.end());
      return result;
    }
  } // namespace

  TEST(SolidLiquidVapourLaw, SolidHugoniotOfAneos)
  {
    // Particle speed and shock speed [km/s], density, temperature [eV], pressure [GPa].
    const double rows[][5] = {{2.0750, 8.2659, 3.6049, .10, 46.309}, {2.4884, 8.8303, 3.7594, .14, 59.328},
                              {2.6602, 9.0644, 3.8215, .16, 65.105}, {2.8163, 9.2771, 3.8770, .18, 70.544},
                              {2.9602, 9.4729, 3.9272, .20, 75.712}, {3.2796, 9.9072, 4.0361, .25, 87.728},
                              {3.5576, 10.285, 4.1279, .30, 98.791}, {3.8063, 10.622, 4.2078, .35, 109.16},
                              {5.1341, 12.4087, 4.6055, .70, 172.01}};
    for (const auto &[u, speed, true_density, temperature, p] : rows)
      {
        SCOPED_TRACE(u);
        const double e = 0.5 * 0.01 * u * u, found = shocked_density(0.1 * u);
        EXPECT_NEAR(found, true_density, 1e-3 * true_density);
        EXPECT_NEAR(u / (1. - 2.7 / found), speed, 2e-3 * speed);
        EXPECT_NEAR(100. * pressure(metal(), found, e), p, 2e-3 * p);
        EXPECT_NEAR(thermal(found, e).temperature / eV, temperature, 0.01 * temperature);
        EXPECT_EQ(thermal(found, e).melt_fraction, 0.);
      }
  }

  TEST(SolidLiquidVapourLaw, ShockMeltingOfAneos)
  {
    // Solid at 172.0, mixed at 190.1, liquid at 200.7 GPa in the table.
    const auto melt = [](double u) { return thermal(shocked_density(u), 0.5 * u * u).melt_fraction; };
    EXPECT_EQ(melt(0.51341), 0.);
    EXPECT_GT(melt(0.54574), 0.);
    EXPECT_LT(melt(0.54574), 1.);
    EXPECT_GT(melt(0.56466), 0.99);
    EXPECT_EQ(melt(0.568), 1.);
    for (const auto &[u, p, temperature] : {std::array{0.54574, 1.9006, 0.75}, std::array{0.56466, 2.0069, 0.80}})
      {
        const double true_density = shocked_density(u);
        EXPECT_NEAR(pressure(metal(), true_density, 0.5 * u * u), p, 3e-3 * p);
        // Short of the 1 % of the solid: the liquid has the specific heat of the solid.
        EXPECT_NEAR(thermal(true_density, 0.5 * u * u).temperature / eV, temperature, 0.035 * temperature);
      }
  }

  TEST(SolidLiquidVapourLaw, MeltingAtZeroPressureOfAneos)
  {
    const ThermalModel::Transitions t = metal().transitions();
    EXPECT_NEAR(t.melt_onset, 0.00664, 0.03 * 0.00664);
    EXPECT_NEAR(t.melt_complete, 0.01062, 0.003 * 0.01062);
    // Density of solid and liquid there, from the pressure alone.
    EXPECT_NEAR(pressure(metal(), 2.5721, t.melt_onset), 0., 1e-3);
    EXPECT_NEAR(pressure(metal(), 2.3766, t.melt_complete), 0., 1e-3);
    EXPECT_NEAR(thermal(2.3766, 0.0085).temperature, 0.082398 * eV, 1.);
    EXPECT_NEAR(thermal(2.5721, 0.0064).melt_temperature, 0.082398 * eV, 5.);
    // Boiling at 1 bar: handbook 2790 K; vaporisation takes 10.9 MJ/kg (Es of the table is 12, from 0 K).
    EXPECT_GT(t.vapour_onset, 0.026);
    EXPECT_LT(t.vapour_onset, 0.034);
    EXPECT_NEAR(t.vapour_complete - t.vapour_onset, 0.115, 0.01);
    EXPECT_NEAR(metal().specific_heat(), 924.5e-8, 1e-8);
  }

  TEST(SolidLiquidVapourLaw, MeltCurveOfAneos)
  {
    // Pressure [GPa], temperature [eV]; on the solidus, sought along the density.
    const double rows[][2] = {{3.85, .10727},  {9.14, .13965},  {16.51, .18179}, {27.04, .23667}, {42.43, .30810},
                              {65.54, .40109}, {101.4, .52215}, {159.4, .67975}, {258.1, .88493}};
    for (const auto &[p, temperature] : rows)
      {
        SCOPED_TRACE(p);
        double lower = 2.58, upper = 7.;
        for (int i = 0; i < 60; ++i)
          {
            const double true_density = 0.5 * (lower + upper);
            // The solid at its melting temperature: e = 3R T + cold energy, from the model's own temperature at 1 e.
            const double e0 = 0., t0 = thermal(true_density, e0).temperature;
            const double e = e0 + metal().specific_heat() * (thermal(true_density, e0).melt_temperature - t0);
            (100. * pressure(metal(), true_density, e) < p ? lower : upper) = true_density;
          }
        EXPECT_NEAR(thermal(lower, 0.).melt_temperature / eV, temperature, 0.03 * temperature);
      }
  }

  TEST(SolidLiquidVapourLaw, PhasesOfTheStates)
  {
    for (const State &s : solid_states)
      EXPECT_EQ(thermal(s.true_density, s.e).melt_fraction, 0.) << s.true_density << " " << s.e;
    for (const State &s : melting_states)
      {
        EXPECT_GT(thermal(s.true_density, s.e).melt_fraction, 0.) << s.true_density << " " << s.e;
        EXPECT_LT(thermal(s.true_density, s.e).melt_fraction, 1.) << s.true_density << " " << s.e;
        EXPECT_GT(pressure(metal(), s.true_density, s.e), 0.);
      }
    for (const State &s : fluid_states)
      {
        const Thermal t = thermal(s.true_density, s.e);
        EXPECT_EQ(t.melt_fraction, 1.) << s.true_density << " " << s.e;
        EXPECT_TRUE(t.vapour_fraction == 0. || t.vapour_fraction == 1.) << s.true_density << " " << s.e;
      }
    for (const State &s : boiling_states)
      {
        EXPECT_GT(thermal(s.true_density, s.e).vapour_fraction, 0.) << s.true_density << " " << s.e;
        EXPECT_LT(thermal(s.true_density, s.e).vapour_fraction, 1.) << s.true_density << " " << s.e;
      }
    for (const State &s : tension_states)
      EXPECT_LT(pressure(metal(), s.true_density, s.e), 0.) << s.true_density << " " << s.e;
  }

  TEST(SolidLiquidVapourLaw, DerivativesAreThoseOfThePressure)
  {
    for (const State &state : all_states())
      expect_exact_derivatives(metal(), state, 0.01, 1e-7, 1e-4);
  }

  TEST(SolidLiquidVapourLaw, PressureAndTemperatureBelongTogether)
  {
    // dS = (de + P dv)/T is total: d(1/T)/dv at constant e = d(P/T)/de at constant v, outside of tension.
    for (const auto &group : {solid_states, melting_states, fluid_states, boiling_states})
      for (const auto &[true_density, e] : group)
        {
          SCOPED_TRACE("density " + std::to_string(true_density) + " e " + std::to_string(e));
          const double v = 1. / true_density;
          if (pressure(metal(), true_density, e) <= 0. || (true_density == 0.9 && e == 0.11))
            continue; // tension fades up to 27/32 of the critical temperature
          const double by_v = slope([&](double x) { return 1. / thermal(1. / x, e).temperature; }, v, 1e-4 * v);
          const double by_e =
              slope([&](double x) { return pressure(metal(), true_density, x) / thermal(true_density, x).temperature; },
                    e, 1e-4 * e);
          EXPECT_NEAR(by_v, by_e, 1e-6 * std::abs(by_e));
        }
  }

  TEST(SolidLiquidVapourLaw, IsentropesThroughEveryPhase)
  {
    expect_isentropic(metal(), {4.03, 0.054}, 2.6, 4000, 2e-4); // the 6.58 km/s case, melting on release
    expect_isentropic(metal(), {4.9, 0.2}, 0.3, 20000, 2e-4);   // liquid into boiling
    expect_isentropic(metal(), {2.7, 0.}, 2.3, 400, 1e-9);      // tension
  }

  TEST(SolidLiquidVapourLaw, PressureHasNoJumpAndRisesWithDensityAndEnergy)
  {
    // From one point of a line to the next by what the derivatives at either end allow.
    const auto expect_step = [](const State &from, const State &to) {
      const double true_density[] = {from.true_density, to.true_density}, e[] = {from.e, to.e};
      double       p[2], c2[2], by_density[2], by_e[2];
      metal().evaluate(true_density, e, p, c2);
      metal().derivatives(true_density, e, by_density, by_e);
      const double largest = std::max(by_density[0], by_density[1]) * (true_density[1] - true_density[0]) +
                             std::max(by_e[0], by_e[1]) * (e[1] - e[0]);
      EXPECT_GE(p[1], p[0] - 1e-12) << true_density[0] << " " << e[0];
      EXPECT_LE(p[1] - p[0], 1.05 * largest + 1e-9) << true_density[0] << " " << e[0];
    };
    for (const double e : {-0.002, 0., 0.004, 0.0068, 0.0085, 0.0105, 0.02, 0.03, 0.05, 0.08, 0.12, 0.147, 0.16, 0.2})
      for (double true_density = 0.01; true_density < 7.; true_density *= 1.0005)
        expect_step({true_density, e}, {true_density * 1.0005, e});
    for (const double true_density : {0.2, 0.6, 1.5, 2.3, 2.5, 2.7, 3.5, 4.5})
      for (double e = -0.002; e < 0.25; e += 1e-5)
        expect_step({true_density, e}, {true_density, e + 1e-5});
  }

  TEST(SolidLiquidVapourLaw, InverseAndLimits)
  {
    for (const State &state : all_states())
      expect_inverse(metal(), state, 0.01, 1e-9);
    EXPECT_NEAR(pressure(metal(), 2.7, 0.), 0., 1e-15);
    EXPECT_NEAR(std::sqrt(sound_speed_squared(metal(), 2.7, 0.)), 0.5424, 0.002);
    EXPECT_THROW(metal().energy_of_pressure(9., 1.), StateError);
    EXPECT_THROW(metal().energy_of_pressure(4., 0.1), StateError);
  }

  TEST(SolidLiquidVapourLaw, BatchGivesTheBitsOfSingleCells)
  {
    const std::vector<State> states = all_states();
    expect_batch_is_scalar(metal(), states);

    std::vector<double> true_density, e, temperature(states.size()), melt(states.size());
    for (const State &state : states)
      {
        true_density.push_back(state.true_density);
        e.push_back(state.e);
      }
    metal().evaluate(true_density, e, ThermalOutput{temperature, {}, melt, {}});
    for (std::size_t i = 0; i < states.size(); ++i)
      {
        EXPECT_EQ(temperature[i], thermal(true_density[i], e[i]).temperature);
        EXPECT_EQ(melt[i], thermal(true_density[i], e[i]).melt_fraction);
        EXPECT_GT(temperature[i], 0.);
      }
  }

  TEST(SolidLiquidVapourLaw, VoidsOpenInTensionAndCloseUnderVapour)
  {
    // Cold, half molten, liquid; liquid above 27/32 of the critical temperature.
    const std::vector<double> rho{1.35, 1.35, 1.35, 0.4}, e{0., 0.009, 0.02, 0.13};
    std::vector<double>       phi{0., 0., 0.3, 0.5};
    relax_void_fraction(metal(), std::numeric_limits<double>::infinity(), 0., {rho, e, {}}, phi);
    for (int i = 0; i < 3; ++i)
      {
        const double true_density = rho[i] / (1. - phi[i]);
        EXPECT_NEAR(pressure(metal(), true_density, e[i]), 0., 1e-10);
        // In balance, tension and pressure agree about the state.
        EXPECT_NEAR(thermal(true_density * (1. - 1e-9), e[i]).temperature,
                    thermal(true_density * (1. + 1e-9), e[i]).temperature, 1e-3);
        EXPECT_NEAR(thermal(true_density * (1. - 1e-9), e[i]).melt_fraction,
                    thermal(true_density * (1. + 1e-9), e[i]).melt_fraction, 1e-5);
      }
    EXPECT_EQ(phi[3], 0.);
    EXPECT_GT(pressure(metal(), 0.4, 0.13), 0.);
  }

  TEST(SolidLiquidVapourLaw, IsItsOwnThermalModel)
  {
    MaterialRequest request;
    request.library           = "aluminium";
    request.thermal_model     = "equation of state";
    request.equation_of_state = "solid-liquid-vapour";
    const Material material   = make_material(request);
    EXPECT_EQ(material.thermal.get(), dynamic_cast<const ThermalModel *>(material.eos.get()));
    request.library           = "aluminium 2024-T4";
    request.equation_of_state = "mie-grueneisen";
    EXPECT_THROW(make_material(request), InputError);
  }
} // namespace whipple
