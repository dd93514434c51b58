// SPDX-License-Identifier: LGPL-2.1-or-later
// Spall with hysteresis, Johnson-Cook damage, and fragment sizes. Numbers are the formulas of doc/theory/failure.md
// worked out by hand.
#include "fixed_thermal.h"

#include <whipple/error.h>
#include <whipple/material/grady_kipp.h>
#include <whipple/material/johnson_cook_damage.h>
#include <whipple/material/material_factory.h>
#include <whipple/material/spall_failure.h>

#include <gtest/gtest.h>

#include <cmath>
#include <limits>
#include <string>
#include <vector>

namespace whipple
{
  namespace
  {
    constexpr double infinite = std::numeric_limits<double>::infinity();

    struct Step
    {
      double energy = 300., pressure = 0., void_fraction = 0., stress = 0.004, strain = 0., dt = 1.;
    };

    double
    after(const FailureModel &failure, const Step &s, double damage = 0.)
    {
      const double density = 8.93;
      failure.advance({{&density, 1},
                       {&s.energy, 1},
                       {&s.pressure, 1},
                       {&s.void_fraction, 1},
                       {&s.stress, 1},
                       {&s.strain, 1},
                       s.dt},
                      {&damage, 1});
      return damage;
    }

    JohnsonCookDamage::Constants
    copper()
    {
      JohnsonCookDamage::Constants constants;
      constants.d                = {0.54, 4.89, -3.03, 0.014, 1.12};
      constants.melt_temperature = 1356.;
      return constants;
    }

    JohnsonCookDamage
    copper_damage()
    {
      return JohnsonCookDamage(copper(), std::make_shared<FixedThermal>());
    }

    std::string
    complaint(const MaterialRequest &request)
    {
      try
        {
          make_material(request);
        }
      catch (const InputError &error)
        {
          return error.what();
        }
      return "";
    }
  } // namespace

  TEST(SpallFailure, NeverHeals)
  {
    const SpallFailure failure(1e-3);
    EXPECT_EQ(after(failure, {.void_fraction = 0.}), 0.);
    EXPECT_EQ(after(failure, {.void_fraction = 1e-3}), 0.);
    EXPECT_EQ(after(failure, {.void_fraction = 1.001e-3}), 1.);
    EXPECT_EQ(after(failure, {.pressure = 0.1, .void_fraction = 0.}, 1.), 1.); // closed again
    EXPECT_EQ(after(failure, {.void_fraction = 0.}, 0.3), 0.3);
    EXPECT_TRUE(failure.needs_voids());
    EXPECT_FALSE(failure.needs_strength());
    EXPECT_THROW(SpallFailure(1.), InputError);
    EXPECT_THROW(SpallFailure(-0.1), InputError);
    EXPECT_THROW(SpallFailure(std::nan("")), InputError);
  }

  TEST(JohnsonCookDamage, GrowsByStrainOverStrainAtFailure)
  {
    const JohnsonCookDamage failure = copper_damage();
    // s = 0.002/0.004 = 0.5, rate 2e5/s, T = 600 K: eps_f = 2.4924415774.
    const Step tension{.energy = 600., .pressure = -0.002, .strain = 0.2};
    EXPECT_NEAR(after(failure, tension), 0.0802426030015477, 1e-15);
    EXPECT_NEAR(after(failure, tension, 0.5), 0.5802426030015477, 1e-15);
    EXPECT_EQ(after(failure, tension, 0.95), 1.);
    EXPECT_EQ(after(failure, tension, 1.), 1.);
    // Compression, s = -1, slower than the reference rate: eps_f = 0.54 + 4.89 exp(3.03) = 101.749.
    EXPECT_NEAR(after(failure, {.pressure = 0.004, .strain = 1e-7}), 1e-7 / 101.74946736211466, 1e-22);
    // No plastic flow, no damage; nor where a melt flows without stress.
    EXPECT_EQ(after(failure, {.pressure = -0.01}, 0.4), 0.4);
    EXPECT_EQ(after(failure, {.pressure = -0.01, .stress = 0., .strain = 0.5}, 0.4), 0.4);
    EXPECT_EQ(after(failure, {.pressure = 1., .stress = 1e-4, .strain = 0.5}, 0.4), 0.4); // eps_f is infinite
    EXPECT_TRUE(failure.needs_strength());
    EXPECT_FALSE(failure.needs_voids());
  }

  TEST(JohnsonCookDamage, DoesNotDependOnTheStepForAGivenRate)
  {
    const JohnsonCookDamage failure = copper_damage();
    double                  damage  = 0.;
    for (int i = 0; i < 100; ++i)
      damage = after(failure, {.energy = 600., .pressure = -0.002, .strain = 0.002, .dt = 0.01}, damage);
    EXPECT_NEAR(damage, 0.0802426030015477, 1e-14);
  }

  // 6061-T6: eps_f = 0 at s = ln(1.45/0.77)/0.47 = 1.346656, half of which leaves 0.286647; and constants without any
  TEST(JohnsonCookDamage, AFitThatRunsOutOfDuctilityIsHeldWhereItStillHasSome)
  {
    JohnsonCookDamage::Constants aluminium;
    aluminium.d = {-0.77, 1.45, -0.47, 0., 0.};
    const JohnsonCookDamage failure(aluminium, nullptr);
    EXPECT_NEAR(failure.end_of_ductility().value(), 1.346656, 1e-6);
    EXPECT_NEAR(failure.largest_triaxiality(), 0.673328, 1e-6);
    const double held = -0.77 + 1.45 * std::exp(-0.47 * 0.673328);
    for (const double s : {0.68, 1.3, 1.4, 3., 100.})
      EXPECT_NEAR(after(failure, {.pressure = -s * 0.004, .strain = 0.01}), 0.01 / held, 1e-7) << s;
    EXPECT_NEAR(after(failure, {.pressure = -0.5 * 0.004, .strain = 0.01}),
                0.01 / (-0.77 + 1.45 * std::exp(-0.47 * 0.5)), 1e-12);
    EXPECT_EQ(after(failure, {.pressure = -10. * 0.004, .strain = 0.}), 0.);

    JohnsonCookDamage::Constants nothing;
    nothing.d = {-1., 0.5, -0.5, 0., 0.};
    EXPECT_NEAR(after(JohnsonCookDamage(nothing, nullptr), {.pressure = -0.004, .strain = 1e-4}), 1e-4 / 0.01, 1e-12);
  }

  // The fit ends at s = 1.5 ([Johnson1985]; LS-DYNA holds s there too): nothing changes below it.
  TEST(JohnsonCookDamage, FitsThatKeepTheirDuctilityAreHeldAtTheirEnd)
  {
    JohnsonCookDamage::Constants steel; // 4340
    steel.d = {0.05, 3.44, -2.12, 0., 0.};
    const JohnsonCookDamage failure(steel, nullptr);
    EXPECT_FALSE(failure.end_of_ductility());
    for (const double s : {-1., 0., 0.6, 1.49, 1.5, 2., 30.})
      EXPECT_NEAR(after(failure, {.pressure = -s * 0.004, .strain = 0.01}),
                  0.01 / (0.05 + 3.44 * std::exp(-2.12 * std::min(s, 1.5))), 1e-12)
          << s;
  }

  TEST(JohnsonCookDamage, SpallAndVoidsAreFailureToo)
  {
    auto constants           = copper();
    constants.spall_strength = 0.013;
    const JohnsonCookDamage failure(constants, std::make_shared<FixedThermal>());
    EXPECT_EQ(after(failure, {.pressure = -0.013}), 0.);
    EXPECT_EQ(after(failure, {.pressure = -0.01301}), 1.);
    EXPECT_EQ(after(copper_damage(), {.pressure = -1.}), 0.); // infinite unless given
    EXPECT_EQ(after(failure, {.void_fraction = 1e-3}), 0.);
    EXPECT_EQ(after(failure, {.void_fraction = 2e-3}), 1.);
    const double density = 8.93, energy = 300., pressure = 0., stress = 0., strain = 0.;
    double       damage = 0.;
    failure.advance({{&density, 1}, {&energy, 1}, {&pressure, 1}, {}, {&stress, 1}, {&strain, 1}, 1.}, {&damage, 1});
    EXPECT_EQ(damage, 0.);
  }

  TEST(JohnsonCookDamage, SaysWhatIsWrong)
  {
    EXPECT_THROW(JohnsonCookDamage(copper(), nullptr), InputError);
    const auto wrong = [](auto change) {
      auto constants = copper();
      change(constants);
      EXPECT_THROW(JohnsonCookDamage(constants, std::make_shared<FixedThermal>()), InputError);
    };
    wrong([](auto &c) { c.d[2] = std::nan(""); });
    wrong([](auto &c) { c.reference_rate = 0.; });
    wrong([](auto &c) { c.melt_temperature = 300.; });
    wrong([](auto &c) { c.spall_strength = -1.; });
    wrong([](auto &c) { c.void_fraction = 1.; });
  }

  TEST(FailureModels, SameBitsInAnyPlaceOfTheBatch)
  {
    const JohnsonCookDamage failure = copper_damage();
    constexpr int           n       = 600;
    std::vector<double>     density(n, 8.93), energy(n), pressure(n), voids(n), stress(n), strain(n), damage(n);
    for (int i = 0; i < n; ++i)
      {
        energy[i]   = 250. + 1.5 * ((91 * i) % n);
        pressure[i] = 1e-5 * (((53 * i) % n) - 400);
        voids[i]    = i % 29 == 0 ? 0.01 : 0.;
        stress[i]   = 1e-5 * ((11 * i) % n);
        strain[i]   = 1e-4 * ((17 * i) % n);
        damage[i]   = 1e-3 * ((7 * i) % n);
      }
    const std::vector<double> before = damage;
    failure.advance({density, energy, pressure, voids, stress, strain, 0.3}, damage);
    for (int i = 0; i < n; ++i)
      {
        ASSERT_EQ(after(failure, {energy[i], pressure[i], voids[i], stress[i], strain[i], 0.3}, before[i]), damage[i]);
        ASSERT_GE(damage[i], before[i]);
        ASSERT_LE(damage[i], 1.);
      }
  }

  TEST(FailureModels, AreMadeFromTheLibrary)
  {
    MaterialRequest request;
    request.library       = "copper OFHC";
    request.thermal_model = "constant specific heat";
    request.strength      = "johnson-cook";
    request.failure       = "johnson-cook damage";
    EXPECT_EQ(make_material(request).failure->name(), "johnson-cook damage");
    request.strength = "none";
    EXPECT_NE(complaint(request).find("needs a strength model"), std::string::npos);
    request.failure = "spall";
    EXPECT_NE(complaint(request).find("needs a void law"), std::string::npos);
  }

  TEST(GradyKipp, BalancesKineticAndSurfaceEnergy)
  {
    // 30 MPa m^(1/2), 2785 kg/m^3, 5328 m/s: W = 5691.92 J/m^2; (sqrt(24) K_Ic / (rho c rate))^(2/3) by hand.
    const double energy = fracture_energy(30e-4, 2.785, 0.5328);
    EXPECT_NEAR(energy, 5691.92123852709e-9, 1e-18);
    const GradyKipp           model(energy);
    const std::vector<double> density(4, 2.785), sound(4, 0.5328), rate{0.01, 0.1, 0., -1.};
    std::vector<double>       size(4);
    model.evaluate(density, sound, rate, {}, size);
    EXPECT_NEAR(size[0], 0.9936306357629447, 1e-12);
    EXPECT_NEAR(size[1], 0.21407123107661236, 1e-12);
    EXPECT_EQ(size[2], infinite);
    EXPECT_EQ(size[3], infinite);
    EXPECT_THROW(GradyKipp(0.), InputError);
    EXPECT_THROW(GradyKipp(std::nan("")), InputError);

    MaterialRequest request;
    request.library   = "aluminium 2024-T4";
    request.void_law  = "rate";
    request.fragments = "grady-kipp";
    make_material(request).fragments->evaluate(density, sound, rate, {}, size);
    EXPECT_NEAR(size[1], 0.21407123107661236, 1e-9);

    // liquid aluminium at 1/us: (48 * 0.9e-9 / 2.785)^(1/3) by hand; half molten: nearly half of W is left
    const std::vector<double> fast(4, 1.), melt{0., 0.5, 1., 1.};
    make_material(request).fragments->evaluate(density, sound, fast, melt, size);
    EXPECT_NEAR(size[0], 0.04612024864, 1e-10);
    EXPECT_NEAR(size[1] / size[0], 0.79374235678, 1e-9);
    EXPECT_NEAR(size[2], 0.0024938, 1e-6);

    request.library = "copper OFHC";
    EXPECT_NE(complaint(request).find("Fracture energy is needed"), std::string::npos);
  }
} // namespace whipple
