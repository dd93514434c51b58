// SPDX-License-Identifier: LGPL-2.1-or-later
// Johnson-Cook, Steinberg-Guinan and the thermal softening of models that know no temperature. Numbers without another
// source are the formulas of doc/theory/strength.md worked out by hand.
#include "complaint.h"
#include "fixed_thermal.h"

#include <whipple/error.h>
#include <whipple/material/johnson_cook.h>
#include <whipple/material/linear_hardening.h>
#include <whipple/material/material_factory.h>
#include <whipple/material/perfectly_plastic.h>
#include <whipple/material/softened_strength.h>
#include <whipple/material/steinberg_guinan.h>

#include <gtest/gtest.h>

#include <cmath>
#include <limits>
#include <string>
#include <vector>

namespace whipple
{
  namespace
  {
    const auto thermal = std::make_shared<const FixedThermal>();

    struct Point
    {
      double density = 2.703, energy = 300., pressure = 0., strain = 0., rate = 0.;
    };
    struct Moduli
    {
      double shear, yield;
    };

    Moduli
    at(const Strength &strength, const Point &p)
    {
      Moduli result{};
      strength.evaluate({{&p.density, 1}, {&p.energy, 1}, {&p.pressure, 1}, {&p.strain, 1}, {&p.rate, 1}},
                        {&result.shear, 1}, {&result.yield, 1});
      return result;
    }

    JohnsonCook::Constants
    johnson_cook_aluminium() // 6061-T6
    {
      return {0.276, 3.24e-3, 1.14e-3, 0.42, 0.002, 1e-6, 1.34, 925., 300.};
    }

    SteinbergGuinan::Constants
    steinberg_aluminium() // 6061-T6, cold-worked by 1 %
    {
      SteinbergGuinan::Constants c;
      c.density               = 2.703;
      c.shear_modulus         = 0.276;
      c.yield_stress          = 0.0029;
      c.maximum_yield_stress  = 0.0068;
      c.hardening_coefficient = 125.;
      c.hardening_exponent    = 0.10;
      c.initial_strain        = 0.01;
      c.pressure_coefficient  = 6.52;
      c.thermal_coefficient   = 6.16e-4;
      c.melt_temperature      = 1220.;
      c.grueneisen            = 1.97;
      c.volume_correction     = 1.5;
      return c;
    }

    /// Scrambled states, cold to molten, and the moduli of each on its own.
    void
    expect_same_bits_in_any_batch(const Strength &strength)
    {
      constexpr int       n = 700;
      std::vector<double> density(n), energy(n), pressure(n), strain(n), rate(n), shear(n), yield(n);
      for (int i = 0; i < n; ++i)
        {
          density[i]  = 2.2 + 0.003 * ((37 * i) % n);
          energy[i]   = 250. + 1.5 * ((91 * i) % n);
          pressure[i] = -0.01 + 0.001 * ((53 * i) % n);
          strain[i]   = 0.002 * ((11 * i) % n);
          rate[i]     = 1e-7 * ((17 * i) % n);
        }
      strength.evaluate({density, energy, pressure, strain, rate}, shear, yield);
      for (int i = 0; i < n; ++i)
        {
          const Moduli one = at(strength, {density[i], energy[i], pressure[i], strain[i], rate[i]});
          ASSERT_EQ(one.shear, shear[i]) << i;
          ASSERT_EQ(one.yield, yield[i]) << i;
          ASSERT_TRUE(shear[i] >= 0. && yield[i] >= 0.) << i;
        }
    }

    std::string
    complaint(const MaterialRequest &request)
    {
      return complaint_of([&] { make_material(request); });
    }
  } // namespace

  TEST(JohnsonCook, HardensWithStrainAndRateAndSoftensWithTemperature)
  {
    const JohnsonCook strength(johnson_cook_aluminium(), thermal);
    EXPECT_DOUBLE_EQ(at(strength, {}).yield, 3.24e-3);
    EXPECT_DOUBLE_EQ(at(strength, {}).shear, 0.276);
    EXPECT_NEAR(at(strength, {.energy = 500., .strain = 0.2, .rate = 0.1}).yield, 3.058972855982281e-3, 1e-15);
    // Below the reference rate and temperature nothing changes.
    EXPECT_EQ(at(strength, {.strain = 0.2, .rate = 0.}).yield, at(strength, {.strain = 0.2, .rate = 1e-6}).yield);
    EXPECT_EQ(at(strength, {.energy = 77., .strain = 0.2}).yield, at(strength, {.energy = 300., .strain = 0.2}).yield);
    // A decade of rate adds C ln 10.
    EXPECT_NEAR(at(strength, {.rate = 1e-2}).yield - at(strength, {.rate = 1e-3}).yield,
                3.24e-3 * 0.002 * std::log(10.), 1e-17);
    EXPECT_TRUE(strength.needs_strain_rate());
    EXPECT_TRUE(strength.softens());
    EXPECT_FALSE(strength.needs_pressure());
  }

  TEST(JohnsonCook, IsZeroAtMelt)
  {
    const JohnsonCook strength(johnson_cook_aluminium(), thermal);
    EXPECT_GT(at(strength, {.energy = 924.9}).yield, 0.);
    EXPECT_EQ(at(strength, {.energy = 925.}).yield, 0.);
    // Where the thermal model melts first, at 1000 K here, the melt has no strength either.
    auto late             = johnson_cook_aluminium();
    late.melt_temperature = 1800.;
    const JohnsonCook tough(late, thermal);
    const Moduli      solid = at(tough, {.energy = 1000.}), half = at(tough, {.energy = 1050.});
    EXPECT_GT(solid.yield, 0.);
    EXPECT_DOUBLE_EQ(half.yield, 0.5 * solid.yield);
    EXPECT_DOUBLE_EQ(half.shear, 0.138);
    EXPECT_EQ(at(tough, {.energy = 1100.}).yield, 0.);
    EXPECT_EQ(at(tough, {.energy = 1100.}).shear, 0.);
  }

  TEST(JohnsonCook, AsksForTheRateOnlyIfItMatters)
  {
    auto constants             = johnson_cook_aluminium();
    constants.rate_coefficient = 0.;
    const JohnsonCook strength(constants, thermal);
    EXPECT_FALSE(strength.needs_strain_rate());
    const double density = 2.7, energy = 300., strain = 0.;
    double       shear, yield;
    strength.evaluate({{&density, 1}, {&energy, 1}, {}, {&strain, 1}, {}}, {&shear, 1}, {&yield, 1});
    EXPECT_DOUBLE_EQ(yield, 3.24e-3);
  }

  TEST(SteinbergGuinan, StiffensWithPressureAndSoftensWithTemperature)
  {
    const SteinbergGuinan strength(steinberg_aluminium(), thermal);
    const Moduli          shocked = at(strength, {2.703 * 1.2, 800., 0.3, 0.05});
    EXPECT_NEAR(shocked.shear, 0.6990159464075965, 1e-14);
    EXPECT_NEAR(shocked.yield, 0.00909741259406754, 1e-16);
    // (1/G0) dG/dP = A and -(1/G0) dG/dT = B at the reference state.
    const double dp = 1e-6, dt = 1e-3;
    EXPECT_NEAR((at(strength, {.pressure = dp}).shear - 0.276) / (0.276 * dp), 6.52, 1e-6);
    EXPECT_NEAR((at(strength, {.energy = 300. + dt}).shear - 0.276) / (0.276 * dt), -6.16e-4, 1e-9);
    // At 800 K, 0.692 of everything is left; hardening would end at 9.4e-3 Mbar without Y_max = 6.8e-3.
    EXPECT_NEAR(at(strength, {.energy = 800., .strain = 1000.}).yield, 0.0047056, 1e-15);
    EXPECT_TRUE(strength.needs_pressure());
    EXPECT_TRUE(strength.softens());
    EXPECT_FALSE(strength.needs_strain_rate());
  }

  TEST(SteinbergGuinan, IsZeroAtAndBeyondMelt)
  {
    const SteinbergGuinan strength(steinberg_aluminium(), thermal);
    // What the thermal model has melted.
    const Moduli solid = at(strength, {.energy = 1000.}), half = at(strength, {.energy = 1050.});
    EXPECT_DOUBLE_EQ(half.shear, 0.5 * solid.shear);
    EXPECT_EQ(at(strength, {.energy = 1100.}).shear, 0.);
    // The model's own melting: 1027.30 K at eta = 0.95, 2114.22 K at eta = 1.2.
    auto early             = steinberg_aluminium();
    early.melt_temperature = 610.;
    const SteinbergGuinan soft(early, thermal);
    EXPECT_GT(at(soft, {.density = 0.95 * 2.703, .energy = 513.65}).yield, 0.);
    EXPECT_EQ(at(soft, {.density = 0.95 * 2.703, .energy = 513.66}).yield, 0.);
    EXPECT_EQ(at(soft, {.density = 0.95 * 2.703, .energy = 513.66}).shear, 0.);
    EXPECT_GT(at(soft, {.density = 1.2 * 2.703, .energy = 999.}).yield, 0.);
    // Hot material in deep tension: the bracket is negative, the moduli are zero.
    EXPECT_EQ(at(strength, {.energy = 900., .pressure = -0.1}).shear, 0.);
    EXPECT_EQ(at(strength, {.energy = 900., .pressure = -0.1}).yield, 0.);
  }

  TEST(SoftenedStrength, FallsToZeroAtMelt)
  {
    const auto             inner = std::make_shared<const LinearHardening>(LinearHardening::Constants{0.25, 4e-3, 0.1});
    const SoftenedStrength strength(inner, thermal);
    EXPECT_DOUBLE_EQ(at(strength, {.strain = 0.1}).yield, 0.014);
    EXPECT_EQ(at(strength, {.energy = 77., .strain = 0.1}).yield, at(*inner, {.strain = 0.1}).yield);
    EXPECT_DOUBLE_EQ(at(strength, {.energy = 650., .strain = 0.1}).yield, 0.007); // half-way from 300 to 1000 K
    EXPECT_DOUBLE_EQ(at(strength, {.energy = 650.}).shear, 0.25);
    EXPECT_NEAR(at(strength, {.energy = 999.9}).yield, 4e-3 * 0.1 / 700., 1e-15);
    for (const double molten : {1000., 1050., 1100., 3000.})
      EXPECT_EQ(at(strength, {.energy = molten, .strain = 1.}).yield, 0.);
    EXPECT_DOUBLE_EQ(at(strength, {.energy = 1025.}).shear, 0.1875);
    EXPECT_EQ(at(strength, {.energy = 1100.}).shear, 0.);
    EXPECT_EQ(strength.name(), "linear hardening");
    EXPECT_TRUE(strength.softens());
    EXPECT_FALSE(inner->softens());
    EXPECT_FALSE(strength.needs_pressure());
    EXPECT_EQ(strength.reference_shear_modulus(), 0.25);
  }

  TEST(SoftenedStrength, LeavesMaterialThatNeverMeltsAlone)
  {
    class NeverMelts : public FixedThermal
    {
      void
      evaluate(std::span<const double> density, std::span<const double> energy,
               const ThermalOutput &output) const override
      {
        FixedThermal::evaluate(density, energy, output);
        std::fill(output.melt_temperature.begin(), output.melt_temperature.end(),
                  std::numeric_limits<double>::infinity());
        std::fill(output.melt_fraction.begin(), output.melt_fraction.end(), 0.);
      }
    };
    const SoftenedStrength strength(std::make_shared<PerfectlyPlastic>(0.25, 4e-3), std::make_shared<NeverMelts>());
    EXPECT_EQ(at(strength, {.energy = 900.}).yield, 4e-3);
    EXPECT_EQ(at(strength, {.energy = 900.}).shear, 0.25);
  }

  TEST(StrengthModels, SameBitsInAnyPlaceOfTheBatch)
  {
    expect_same_bits_in_any_batch(JohnsonCook(johnson_cook_aluminium(), thermal));
    expect_same_bits_in_any_batch(SteinbergGuinan(steinberg_aluminium(), thermal));
    expect_same_bits_in_any_batch(
        SoftenedStrength(std::make_shared<LinearHardening>(LinearHardening::Constants{0.25, 4e-3, 0.1}), thermal));
  }

  TEST(StrengthModels, SayWhatIsWrong)
  {
    const auto plastic = std::make_shared<const PerfectlyPlastic>(0.25, 4e-3);
    EXPECT_THROW(JohnsonCook(johnson_cook_aluminium(), nullptr), InputError);
    EXPECT_THROW(SteinbergGuinan(steinberg_aluminium(), nullptr), InputError);
    EXPECT_THROW(SoftenedStrength(plastic, nullptr), InputError);
    EXPECT_THROW(SoftenedStrength(nullptr, thermal), InputError);
    EXPECT_THROW(SoftenedStrength(plastic, thermal, -1.), InputError);
    EXPECT_THROW(SoftenedStrength(std::make_shared<JohnsonCook>(johnson_cook_aluminium(), thermal), thermal),
                 InputError);
    auto cold             = johnson_cook_aluminium();
    cold.melt_temperature = 300.;
    EXPECT_THROW(JohnsonCook(cold, thermal), InputError);
    auto falling                 = steinberg_aluminium();
    falling.maximum_yield_stress = 0.0025; // 4340 steel as the Uintah files have it
    EXPECT_THROW(SteinbergGuinan(falling, thermal), InputError);
  }

  TEST(StrengthModels, AreMadeFromTheLibrary)
  {
    MaterialRequest request;
    request.library       = "copper OFHC";
    request.strength      = "johnson-cook";
    request.thermal_model = "constant specific heat";
    Point cold;
    cold.density              = 8.93;
    cold.energy               = 0.;
    const Moduli johnson_cook = at(*make_material(request).strength, cold);
    EXPECT_DOUBLE_EQ(johnson_cook.yield, 9e-4); // A = 90 MPa, not Steinberg's 120
    EXPECT_DOUBLE_EQ(johnson_cook.shear, 0.477);

    request.strength         = "steinberg-guinan";
    const Material steinberg = make_material(request);
    EXPECT_DOUBLE_EQ(at(*steinberg.strength, cold).yield, 1.2e-3);
    cold.strain = 0.3; // 0.12 GPa (1 + 36 0.3)^0.45 = 0.364 GPa
    EXPECT_NEAR(at(*steinberg.strength, cold).yield, 1.2e-3 * std::pow(11.8, 0.45), 1e-15);

    request.thermal_model = "none";
    EXPECT_NE(complaint(request).find("'steinberg-guinan': needs a thermal model"), std::string::npos);
    request.thermal_model = "constant specific heat";
    request.library       = "zinc";
    request.strength      = "johnson-cook";
    EXPECT_NE(complaint(request).find("Johnson-Cook hardening modulus is needed"), std::string::npos);
  }
} // namespace whipple
