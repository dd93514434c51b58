// SPDX-License-Identifier: LGPL-2.1-or-later
// Tabulated equation of state: against the analytic law that the table was made of, against its own pressure, and bad
// tables.
#include "../figure.h"
#include "analytic_solid.h"
#include "table_writer.h"

#include <whipple/error.h>
#include <whipple/material/material_factory.h>
#include <whipple/material/mie_grueneisen.h>
#include <whipple/material/tabulated.h>

#include <gtest/gtest.h>

#include <cmath>
#include <vector>

namespace
{
  using namespace whipple;
  using analytic_solid::states;
  using Analytic = analytic_solid::Solid;
  using eos_check::pressure;
  using eos_check::sound_speed_squared;

  /// Table of the law: n + 1 densities 1.5 ... 6 g/cm^3 and n + 1 temperatures 100 ... 20000 K, or energies.
  table_writer::Table
  table_of(int n, bool over_energy = false)
  {
    table_writer::Table table;
    for (int i = 0; i <= n; ++i)
      {
        table.density.push_back(1.5 * std::pow(4., static_cast<double>(i) / n));
        table.second.push_back(over_energy ? -0.02 + 0.6 * i / n : 100. * std::pow(200., static_cast<double>(i) / n));
      }
    table.over_energy      = over_energy;
    table.reference_energy = 100. * Analytic::energy(2.7, 300.); // MJ/kg
    for (const double rho : table.density)
      for (const double y : table.second)
        {
          const double e = over_energy ? y + 0.35 : Analytic::energy(rho, y);
          const double t = over_energy ? Analytic::temperature(rho, e) : y;
          table.energy.push_back(100. * e);
          table.temperature.push_back(t);
          table.pressure.push_back(100. * Analytic::pressure(rho, t));
        }
    if (over_energy)
      for (double &e : table.second)
        e = 100. * (e + 0.35);
    return table;
  }

  Tabulated
  read(const table_writer::Table &table)
  {
    const table_writer::File file("tabulated_test.h5");
    table_writer::write(file.path(), table);
    return Tabulated(file.path());
  }

  const double zero = Analytic::energy(2.7, 300.);

  TEST(TabulatedOrder, PressureSoundSpeedAndTemperatureConverge)
  {
    const analytic_solid::Errors coarse = analytic_solid::errors(read(table_of(32)), zero),
                                 fine   = analytic_solid::errors(read(table_of(64)), zero);
    figure::expect_at_most("error of P of a 65 x 65 table over (density, temperature), relative to K + |P|", fine.p,
                           1e-6);
    figure::expect_at_most("error of c^2 of the same table", fine.c2, 5e-5);
    figure::expect_at_most("error of T of the same table", fine.t, 1e-4);
    // cubic with slopes of fourth order
    figure::record("order of P", std::log2(coarse.p / fine.p), ">= 3.5");
    figure::record("order of c^2", std::log2(coarse.c2 / fine.c2), ">= 2.5");
    EXPECT_GE(std::log2(coarse.p / fine.p), 3.5);
    EXPECT_GE(std::log2(coarse.c2 / fine.c2), 2.5);
  }

  TEST(TabulatedOrder, AStiffenedGasIsReproduced)
  {
    // P = c0^2 (rho - rho0) + (k - 1) rho e is within the space of the interpolant
    table_writer::Table table;
    table.over_energy      = true;
    table.reference_energy = 0.;
    for (int i = 0; i <= 10; ++i)
      {
        table.density.push_back(1. + 0.3 * i + 0.02 * i * i);
        table.second.push_back(-1. + 2. * i + 0.1 * i * i);
      }
    for (const double rho : table.density)
      for (const double e : table.second)
        table.pressure.push_back(100. * (0.3 * (rho - 2.7) + 1.2 * rho * 0.01 * e));
    const Tabulated law = read(table);
    for (const double rho : {0.9, 1.3, 2.7, 5., 7.})
      for (const double e : {-0.02, 0., 0.11, 0.4})
        {
          const double p = 0.3 * (rho - 2.7) + 1.2 * rho * e;
          EXPECT_NEAR(pressure(law, rho, e), p, 1e-13);
          EXPECT_NEAR(sound_speed_squared(law, rho, e), 0.3 + 1.2 * e + 1.2 * p / rho, 1e-12);
        }
    EXPECT_EQ(law.reference_density(), 2.7);
    EXPECT_FALSE(law.has_temperature());
  }

  TEST(TabulatedDerivatives, AreThoseOfThePressure)
  {
    for (const bool over_energy : {false, true})
      {
        const Tabulated law = read(table_of(24, over_energy));
        for (const auto &[rho, e] : states(200))
          eos_check::expect_exact_derivatives(law, {rho, e - zero}, 0.01, 2e-5, 1e-5);
        // and outside of the table
        for (const auto &state : {eos_check::State{1.2, 0.1}, {7.5, 0.4}, {3., 5.}, {3., -0.5}, {0.3, -0.2}, {9., 9.}})
          eos_check::expect_exact_derivatives(law, state, 0.01, 2e-5, 1e-5);
      }
  }

  TEST(TabulatedDerivatives, AreContinuousAcrossNodesAndEdges)
  {
    const table_writer::Table table = table_of(12);
    const Tabulated           law   = read(table);
    for (const double rho : table.density)
      for (const double e : {-0.3, 0., 0.2, 3.})
        {
          double dp_ddensity[2], dp_de[2];
          for (int side = 0; side < 2; ++side)
            {
              const double at = rho * (1. + (side == 0 ? -1e-9 : 1e-9));
              law.derivatives({&at, 1}, {&e, 1}, {&dp_ddensity[side], 1}, {&dp_de[side], 1});
            }
          EXPECT_NEAR(dp_ddensity[0], dp_ddensity[1], 1e-6 * (1. + std::abs(dp_ddensity[0])));
          EXPECT_NEAR(dp_de[0], dp_de[1], 1e-6 * (1. + std::abs(dp_de[0])));
        }
  }

  TEST(TabulatedInverse, EnergyOfPressure)
  {
    const Tabulated law = read(table_of(24));
    figure::Largest error("e(rho, P(rho, e)) - e of a tabulated law, Mbar cm^3/g", "<= 1e-13");
    for (const auto &[rho, e] : states(500))
      {
        const double found = law.energy_of_pressure(rho, pressure(law, rho, e - zero));
        EXPECT_NEAR(found, e - zero, 1e-13);
        error(found - (e - zero));
      }
    for (const auto &[rho, e] : {eos_check::State{1.2, 0.1}, {7.5, 0.4}, {3., 5.}, {3., -0.5}}) // outside
      EXPECT_NEAR(law.energy_of_pressure(rho, pressure(law, rho, e)), e, 1e-12);
    EXPECT_THROW(law.energy_of_pressure(-1., 0.), StateError);
  }

  TEST(TabulatedMonotone, AlongGridLinesAcrossAKink)
  {
    // a pressure with a plateau and kinks, flat in places, and steep in density
    table_writer::Table table;
    table.over_energy      = true;
    table.reference_energy = 0.;
    for (int i = 0; i <= 12; ++i)
      {
        table.density.push_back(0.5 + 0.4 * i);
        table.second.push_back(i * (i + 1.));
      }
    for (const double rho : table.density)
      for (const double e : table.second)
        table.pressure.push_back(rho < 2.6 ? std::max(0., e - 40. * rho) : 300. * (rho - 2.6) + 4. * std::min(e, 30.));
    const Tabulated law  = read(table);
    const auto      fall = [&law](double rho) {
      double deepest = 0., highest = -INFINITY;
      for (double e = 0.; e < 1.6; e += 0.0017)
        {
          const double p = pressure(law, rho, e);
          highest        = std::max(highest, p);
          deepest        = std::max(deepest, highest - p);
        }
      return deepest;
    };
    for (const double rho : table.density)
      EXPECT_LE(fall(rho), 1e-12) << rho;
    // between them it may fall a little next to the kinks, here where P rises by 1.2 Mbar from row to row
    double between = 0.;
    for (double rho = 0.5; rho <= 5.3; rho += 0.013)
      between = std::max(between, fall(rho));
    figure::expect_at_most("fall of P with e between the rows of a table with kinks, Mbar", between, 0.06);
    // the steps in density are not overshot
    for (const double e : {0., 0.3, 1.})
      for (double rho = 0.5; rho < 2.5; rho += 0.01)
        EXPECT_GE(pressure(law, rho, e), -1e-12);
  }

  TEST(TabulatedRows, RoundedLevelAndFallingEnergiesAreLeftOut)
  {
    const table_writer::Table good = table_of(32);
    const Tabulated           law  = read(good);
    table_writer::Table       bad  = good;
    const std::size_t         m    = good.second.size();
    bad.energy[4 * m + 1]          = bad.energy[4 * m];                // level
    bad.energy[7 * m + 1]          = bad.energy[7 * m] * (1. + 1e-10); // rounding of a text
    bad.energy[9 * m + 10]         = bad.energy[9 * m + 8];            // falls
    bad.energy[11 * m + 2]         = bad.energy[11 * m + 4];           // one above the next two
    const table_writer::File file("tabulated_test.h5");
    table_writer::write(file.path(), bad);
    const EquationOfStateTable table = read_equation_of_state_table(file.path());
    EXPECT_EQ(table.points_left_out, 4u);
    const Tabulated thinned(table);
    double          error = 0.;
    for (const auto &[rho, e] : states(500))
      {
        const double p = pressure(law, rho, e - zero);
        error =
            std::max(error, std::abs(pressure(thinned, rho, e - zero) - p) / (Analytic::bulk_modulus + std::abs(p)));
      }
    figure::expect_at_most("change of P where points of a 33 x 33 table are left out, relative to K + |P|", error,
                           1e-3);
  }

  TEST(TabulatedInverse, WherePressureFallsWithEnergyTheEnergyNearestToRest)
  {
    // water below 4 C, a melting solid: P falls with e at constant density, then rises
    table_writer::Table table;
    table.over_energy       = true;
    table.reference_density = 1.;
    table.reference_energy  = 0.5;
    for (int i = 0; i <= 8; ++i)
      {
        table.density.push_back(0.6 + 0.1 * i);
        table.second.push_back(0.25 * i);
      }
    for (const double rho : table.density)
      for (const double e : table.second)
        table.pressure.push_back(2. * (rho - 1.) + 0.2 * (e - 1.) * (e - 1.));
    const Tabulated law = read(table);
    for (const double rho : {0.8, 1., 1.07})
      for (const double e : {-0.004, -0.001, 0.001, 0.003}) // falling: up to 0.005 above the reference
        EXPECT_NEAR(law.energy_of_pressure(rho, pressure(law, rho, e)), e, 1e-12) << rho << " " << e;
    // below the lowest pressure of the row there is none
    EXPECT_THROW(law.energy_of_pressure(1., -0.01), StateError);
  }

  TEST(TabulatedThermal, TemperatureFractionsAndConsistency)
  {
    table_writer::Table table = table_of(64);
    for (std::size_t k = 0; k < table.temperature.size(); ++k)
      {
        table.melt_fraction.push_back(std::clamp((table.temperature[k] - 900.) / 1000., 0., 1.));
        table.vapour_fraction.push_back(table.temperature[k] > 4000. ? 1. : 0.);
      }
    for (const double rho : table.density)
      table.melt_temperature.push_back(400. * rho);
    const Tabulated law = read(table);
    ASSERT_TRUE(law.has_temperature());
    const double rho = 2.7, e = Analytic::energy(2.7, 1400.) - zero;
    double       t, melt, fraction, vapour;
    law.evaluate({&rho, 1}, {&e, 1}, ThermalOutput{{&t, 1}, {&melt, 1}, {&fraction, 1}, {&vapour, 1}});
    EXPECT_NEAR(t, 1400., 0.5);
    EXPECT_NEAR(melt, 1080., 1e-9);
    EXPECT_NEAR(fraction, 0.5, 0.02);
    EXPECT_EQ(vapour, 0.);
    EXPECT_NEAR(law.specific_heat(), Analytic::heat + Analytic::electrons * 300., 1e-3 * Analytic::heat);
    const auto transitions = law.transitions();
    EXPECT_GT(transitions.melt_complete, transitions.melt_onset);
    EXPECT_GT(transitions.vapour_onset, transitions.melt_complete);
    EXPECT_NEAR(transitions.melt_onset, Analytic::energy(2.6, 900.) - zero, 0.002);
    // below the lowest row: its temperature
    const double cold = -0.1;
    law.evaluate({&rho, 1}, {&cold, 1}, ThermalOutput{{&t, 1}, {}, {}, {}});
    EXPECT_NEAR(t, 100., 1e-6);

    const auto consistency = law.inconsistency();
    std::cout << "thermodynamic inconsistency of a 65 x 65 table of a consistent law: largest " << consistency.largest
              << " at " << consistency.density << " g/cm^3, " << consistency.energy << " Mbar cm^3/g; median "
              << consistency.median << "\n";
    figure::expect_at_most("median thermodynamic inconsistency of a table of a consistent law", consistency.median,
                           1e-4);
    // a table that is not consistent is found out: a cold pressure 10 % too high, which is not the slope of the cold
    // energy
    for (std::size_t k = 0; k < table.pressure.size(); ++k)
      table.pressure[k] += 10. * Analytic::cold_pressure(table.density[k / table.second.size()]);
    EXPECT_GT(read(table).inconsistency().median, 0.01);
  }

  TEST(TabulatedThermal, MadeOfARequest)
  {
    table_writer::Table      table = table_of(12);
    const table_writer::File file("tabulated_test.h5");
    table_writer::write(file.path(), table);
    MaterialRequest request;
    request.name              = "solid";
    request.equation_of_state = "tabulated";
    request.thermal_model     = "equation of state";
    EXPECT_THROW(make_material(request), InputError); // no table
    request.texts["Table"]  = file.path();
    const Material material = make_material(request);
    EXPECT_EQ(material.eos->reference_density(), 2.7);
    ASSERT_TRUE(material.thermal);
    EXPECT_NEAR(material.thermal->specific_heat(), Analytic::heat, 0.1 * Analytic::heat);
    request.equation_of_state = "mie-grueneisen";
    request.library           = "copper OFHC";
    request.texts.clear();
    EXPECT_THROW(make_material(request), InputError);
    // a table without temperatures
    request                   = {};
    request.equation_of_state = "tabulated";
    request.thermal_model     = "equation of state";
    request.texts["Table"]    = file.path();
    table                     = table_of(12, true);
    table.temperature.clear();
    table_writer::write(file.path(), table);
    EXPECT_THROW(make_material(request), InputError);
    request.thermal_model = "none";
    EXPECT_NO_THROW(make_material(request));
  }

  TEST(TabulatedBits, DoNotDependOnThePlaceInTheArray)
  {
    const Tabulated     law = read(table_of(24));
    std::vector<double> rho, e;
    for (const auto &state : states(1000))
      {
        rho.push_back(state.true_density);
        e.push_back(2. * state.e - 0.2);
      }
    std::vector<double> p(1000), c2(1000), dp_ddensity(1000), dp_de(1000);
    law.evaluate(rho, e, p, c2);
    law.derivatives(rho, e, dp_ddensity, dp_de);
    for (std::size_t i = 0; i < 1000; ++i)
      {
        double alone[4];
        law.evaluate({&rho[i], 1}, {&e[i], 1}, {&alone[0], 1}, {&alone[1], 1});
        law.derivatives({&rho[i], 1}, {&e[i], 1}, {&alone[2], 1}, {&alone[3], 1});
        ASSERT_EQ(std::memcmp(&alone[0], &p[i], sizeof(double)), 0);
        ASSERT_EQ(std::memcmp(&alone[1], &c2[i], sizeof(double)), 0);
        ASSERT_EQ(std::memcmp(&alone[2], &dp_ddensity[i], sizeof(double)), 0);
        ASSERT_EQ(std::memcmp(&alone[3], &dp_de[i], sizeof(double)), 0);
      }
  }

  void
  expect_rejected(const table_writer::Table &table, const std::string &words)
  {
    try
      {
        read(table);
        ADD_FAILURE() << "accepted, not rejected with '" << words << "'";
      }
    catch (const InputError &error)
      {
        const std::string message = error.what();
        EXPECT_NE(message.find("tabulated_test.h5"), std::string::npos) << message;
        EXPECT_NE(message.find(words), std::string::npos) << message;
        EXPECT_EQ(message.find('\n'), std::string::npos) << message;
      }
  }

  TEST(TabulatedInput, BadTablesAreRejectedInOneLine)
  {
    const table_writer::Table good = table_of(6);
    EXPECT_NO_THROW(read(good));
    const auto spoilt = [&good](auto &&change) {
      table_writer::Table table = good;
      change(table);
      return table;
    };
    using Table = table_writer::Table;
    expect_rejected(spoilt([](Table &t) { t.pressure[2 * 7 + 3] = std::nan(""); }),
                    "pressure[2, 3] = 'nan GPa': must be finite: the table has a hole");
    expect_rejected(spoilt([](Table &t) { std::swap(t.density[1], t.density[2]); }),
                    "density[2] = '1.889881575 g/cm^3': must be greater than the value before it");
    expect_rejected(spoilt([](Table &t) { t.density[0] = 0.; }), "density[0] = '0 g/cm^3': must be > 0");
    expect_rejected(spoilt([](Table &t) { t.second[4] = t.second[3]; }), "temperature[4]");
    expect_rejected(spoilt([](Table &t) { t.energy[7 + 3] = t.energy[7 + 6]; }), "energy[1, 4]");
    expect_rejected(spoilt([](Table &t) { t.energy[7 + 3] = t.energy[7 + 6]; }), "by more than 1 % of the row's range");
    expect_rejected(spoilt([](Table &t) { std::fill_n(t.energy.begin() + 14, 7, 3.); }),
                    "energy[2, 0] = '3 MJ/kg': fewer than two energies of this row rise");
    expect_rejected(spoilt([](Table &t) { t.pressure[3 * 7 + 2] = 1e300; }),
                    "pressure[3, 2] = '1e+300 GPa': must be at most 1e+24 GPa in size");
    expect_rejected(spoilt([](Table &t) { t.energy[6] = 1e200; }), "energy[0, 6] = '1e+200 MJ/kg': must be at most");
    expect_rejected(spoilt([](Table &t) { t.density[6] = 1e30; }), "density[6] = '1e+30 g/cm^3': must be at most");
    expect_rejected(spoilt([](Table &t) { t.second[0] = -5.; }), "temperature[0] = '-5 K': must be >= 0");
    expect_rejected(spoilt([](Table &t) { t.reference_energy = std::nan(""); }),
                    "attribute reference_energy = 'nan': must be an energy of at most");
    expect_rejected(spoilt([](Table &t) { t.reference_density = std::nan(""); }),
                    "must be among the densities of the table");
    expect_rejected(spoilt([](Table &t) {
                      for (double &p : t.pressure)
                        p *= -1.;
                    }),
                    "square of the sound speed at reference_density and reference_energy");
    expect_rejected(spoilt([](Table &t) { t.melt_fraction.assign(49, 1.5); }),
                    "melt_fraction[0, 0] = '1.5 1': must be in 0 ... 1");
    expect_rejected(spoilt([](Table &t) { t.melt_temperature.assign(5, 900.); }),
                    "melt_temperature, extent = '5': must be 7");
    expect_rejected(spoilt([](Table &t) { t.missing = "pressure"; }), "dataset 'pressure' is missing");
    expect_rejected(spoilt([](Table &t) { t.missing = "energy"; }), "dataset 'energy' is missing");
    expect_rejected(spoilt([](Table &t) { t.missing = "reference_density"; }),
                    "attribute 'reference_density' is missing");
    expect_rejected(spoilt([](Table &t) { t.reference_density = 20.; }), "must be among the densities of the table");
    expect_rejected(spoilt([](Table &t) { t.pressure_units = "psi"; }),
                    "pressure, attribute units = 'psi': must be GPa | Mbar | Pa | dyn/cm^2");
    expect_rejected(spoilt([](Table &t) { t.pressure_units = ""; }), "dataset 'pressure' has no attribute 'units'");
    EXPECT_THROW(Tabulated("no_such_table.h5"), InputError);
  }
} // namespace
