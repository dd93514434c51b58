// SPDX-License-Identifier: LGPL-2.1-or-later
// The Riemann solver against values of another program: ideal gases (set-ups of [ExactPack]), Hugoniots of solids.
#include "exact_flow_check.h"

#include <whipple/exact/riemann.h>
#include <whipple/material/ideal_gas.h>
#include <whipple/material/material_library.h>
#include <whipple/material/mie_grueneisen.h>
#include <whipple/material/stiffened_gas.h>

#include <gtest/gtest.h>

#include <cmath>

namespace
{
  using namespace whipple;
  using exact::Riemann;

  Riemann::State
  gas(double exponent, double density, double velocity, double pressure)
  {
    return {std::make_shared<IdealGas>(exponent, 1.), density, velocity, pressure / ((exponent - 1.) * density)};
  }

  TEST(ExactRiemann, Sod)
  {
    const Riemann riemann(gas(1.4, 1., 0., 1.), gas(1.4, 0.125, 0., 0.1), 0.5);
    EXPECT_NEAR(riemann.pressure(), 0.3031301781, 1e-10);
    EXPECT_NEAR(riemann.velocity(), 0.92745262, 1e-8);
    EXPECT_NEAR(riemann.on_ray(0.92).density, 0.4263194282, 1e-9);
    EXPECT_NEAR(riemann.on_ray(0.93).density, 0.2655737117, 1e-9);
    EXPECT_NEAR(riemann.fastest_right(), 1.7521557, 1e-7);
    EXPECT_NEAR(riemann.fastest_left(), -1.1832160, 1e-7);
    const std::vector<double> breaks = riemann.breaks(1.);
    ASSERT_EQ(breaks.size(), 4u);
    EXPECT_NEAR(breaks[1], 0.5 - 0.0702728, 1e-7);
    // in the fan of an ideal gas u = 2 (c0 + x/t) / (k + 1)
    const double u = 2. / 2.4 * (std::sqrt(1.4) - 0.6);
    EXPECT_NEAR(riemann.on_ray(-0.6).velocity, u, 1e-11);
    EXPECT_NEAR(riemann.on_ray(-0.6).density, std::pow(1. - 0.2 * u / std::sqrt(1.4), 5.), 1e-11);
    // a mean across fan, contact and shock, by the midpoint rule
    double sum = 0;
    for (int i = 0; i < 100000; ++i)
      sum += 1e-5 * riemann.on_ray(-1. + 3. * (i + 0.5) * 1e-5).density;
    EXPECT_NEAR(riemann.mean_density(-1., 2.), sum, 1e-5);
  }

  TEST(ExactRiemann, EinfeldtOneTwoThree)
  {
    const Riemann riemann(gas(1.4, 1., -2., 0.4), gas(1.4, 1., 2., 0.4));
    EXPECT_NEAR(riemann.pressure(), 0.00189387, 1e-8);
    EXPECT_NEAR(riemann.velocity(), 0., 1e-12);
    EXPECT_NEAR(riemann.on_ray(0.01).density, 0.0218521, 1e-7);
    EXPECT_FALSE(riemann.shock_position(1.).has_value());
  }

  TEST(ExactRiemann, LeBlanc)
  {
    const Riemann classic(gas(5. / 3., 1., 0., 1. / 15.), gas(5. / 3., 1e-3, 0., 2. / 3. * 1e-10));
    EXPECT_NEAR(classic.pressure(), 5.155779277e-4, 1e-13);
    EXPECT_NEAR(classic.velocity(), 0.6218386714, 1e-10);
    EXPECT_NEAR(classic.on_ray(0.6).density, 0.05407933535, 1e-11);
    EXPECT_NEAR(classic.on_ray(0.7).density, 0.00399999806, 1e-11);
    EXPECT_NEAR(classic.fastest_right(), 0.8291183625, 1e-10);
    EXPECT_NEAR(classic.fastest_left(), -1. / 3., 1e-10);
    EXPECT_NEAR(classic.breaks(1.)[1], 0.4957849, 1e-7);
    const Riemann table(gas(5. / 3., 1., 0., 1. / 15.), gas(5. / 3., 1e-2, 0., 2. / 3. * 1e-10));
    EXPECT_NEAR(table.pressure(), 0.002895213233, 1e-12);
    EXPECT_NEAR(table.velocity(), 0.4659838851, 1e-10);
    EXPECT_NEAR(table.on_ray(0.4).density, 0.15228709, 1e-8);
    EXPECT_NEAR(table.fastest_right(), 0.6213118647, 1e-10);
  }

  TEST(ExactRiemann, TwoGases)
  {
    const Riemann riemann(gas(2., 1., 0., 2.), gas(1.4, 0.125, 0., 0.1));
    EXPECT_NEAR(riemann.pressure(), 0.4303319372, 1e-10);
    EXPECT_NEAR(riemann.velocity(), 1.275709681, 1e-9);
    EXPECT_NEAR(riemann.fastest_right(), 2.0715179, 1e-7);
  }

  Riemann::State
  solid(const std::string &name, double velocity)
  {
    const MaterialConstants &m = find_material(name);
    return {std::make_shared<MieGrueneisen>(
                MieGrueneisen::Constants{m.density, m.sound_speed, m.hugoniot_slope, m.grueneisen}),
            m.density, velocity, 0.};
  }

  /// The impact of a plate on its like shocks both to P = rho0 (c0 + s u) u with u = V / 2.
  TEST(ExactRiemann, SymmetricImpactOfSolids)
  {
    for (const auto &[name, gpa] : {std::pair{"aluminium 1100-O", 59.104}, std::pair{"aluminium 6061-T6", 59.061},
                                    std::pair{"copper OFHC", 171.065}, std::pair{"tantalum", 267.46}})
      {
        const Riemann            riemann(solid(name, 0.5), solid(name, 0.));
        const MaterialConstants &m = find_material(name);
        EXPECT_NEAR(riemann.velocity(), 0.25, 1e-10);
        EXPECT_NEAR(riemann.fastest_right(), m.sound_speed + m.hugoniot_slope * 0.25, 1e-9);
        EXPECT_NEAR(riemann.pressure() * 100, gpa, 1e-4 * gpa);
      }
  }

  /// Pulled apart, aluminium goes into tension by two mirrored fans.
  TEST(ExactRiemann, TensionBetweenSolids)
  {
    const Riemann            riemann(solid("aluminium 1100-O", -0.01), solid("aluminium 1100-O", 0.01));
    const MaterialConstants &m = find_material("aluminium 1100-O");
    EXPECT_NEAR(riemann.velocity(), 0., 1e-12);
    EXPECT_NEAR(riemann.pressure(), -m.density * m.sound_speed * 0.01, 0.03 * m.density * m.sound_speed * 0.01);
  }

  /// The closed form of two stiffened gases is that of ideal ones with p + p_inf in place of p.
  TEST(ExactRiemann, StiffenedGas)
  {
    const double k = 4.4, p_inf = 6e-3, c0 = std::sqrt(k * p_inf / 1.);
    const auto   water  = std::make_shared<StiffenedGas>(StiffenedGas::Constants{1., c0, k});
    const auto   energy = [&](double density, double pressure) { return water->energy_of_pressure(density, pressure); };
    const Riemann riemann({water, 1., 0., energy(1., 1e-2)}, {water, 0.9, 0., energy(0.9, 1e-6)});
    const Riemann shifted(gas(k, 1., 0., 1e-2 + p_inf), gas(k, 0.9, 0., 1e-6 + p_inf));
    EXPECT_NEAR(riemann.pressure(), shifted.pressure() - p_inf, 1e-12);
    EXPECT_NEAR(riemann.velocity(), shifted.velocity(), 1e-11);
    EXPECT_NEAR(riemann.fastest_right(), shifted.fastest_right(), 1e-10);
  }

  TEST(ExactRiemann, SolvesTheEulerEquations)
  {
    const exact_check::Flow sod{
        1, [](double density, double energy) { return exact::fluid_point(IdealGas(1.4, 1.), density, energy); }};
    const Riemann gases(gas(1.4, 1., 0., 1.), gas(1.4, 0.125, 0., 0.1), 0.5);
    exact_check::expect_euler(sod, gases, {0.05, 0.95}, 0.2);
    exact_check::expect_shock(gases, *gases.shock_position(0.2), 0.2);

    const Riemann::State    aluminium = solid("aluminium 1100-O", 0.);
    const exact_check::Flow metal{
        1, [&](double density, double energy) { return exact::fluid_point(*aluminium.eos, density, energy); }};
    const Riemann::State hot{aluminium.eos, 3.5, 0., 0.05};
    const Riemann        release(hot, aluminium);
    exact_check::expect_euler(metal, release, {-1., 1.}, 1.);
    exact_check::expect_shock(release, *release.shock_position(1.), 1.);
  }

  TEST(ExactRiemann, RefusesVacuum)
  {
    EXPECT_THROW(Riemann(gas(1.4, 1., -20., 0.4), gas(1.4, 1., 20., 0.4)), StateError);
  }
} // namespace
