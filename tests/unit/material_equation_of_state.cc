// SPDX-License-Identifier: LGPL-2.1-or-later
// Contract of every equation of state, at the states that impacts visit: derivatives against finite
// differences of P alone, energy_of_pressure as the inverse, reference states, typed errors.
#include <whipple/material/ideal_gas.h>
#include <whipple/material/isothermal.h>
#include <whipple/material/linear_polynomial.h>
#include <whipple/material/mie_grueneisen.h>
#include <whipple/material/stiffened_gas.h>

#include <gtest/gtest.h>

#include <cmath>
#include <cstring>
#include <memory>
#include <vector>

namespace whipple
{
  namespace
  {
    const MieGrueneisen::Constants aluminium{2.785, 0.5328, 1.338, 2.0};
    const MieGrueneisen::Constants lead{11.35, 0.2051, 1.46, 2.77};

    struct Case
    {
      std::string                            label;
      std::shared_ptr<const EquationOfState> eos;
      double                                 stiffness; ///< c0^2 [cm^2/us^2], the scale of c^2
      std::vector<std::array<double, 2>>     states;    ///< gamma / gamma0, e
    };

    // Shocked; released, hot and a little expanded; distended cold (tension); far expanded vapour.
    const std::vector<std::array<double, 2>> solid_states = {{1.0001, 1e-6}, {1.2, 0.005}, {1.5, 0.054}, {1.7, 0.125},
                                                             {0.995, 0.},    {0.93, 0.01}, {0.9, 0.},    {0.6, 0.05},
                                                             {0.5, 0.},      {0.2, 0.2}};
    const std::vector<std::array<double, 2>> gas_states   = {{1., 2.5}, {0.125, 2.}, {4., 0.5}, {1e-3, 1e-4}};

    std::vector<Case>
    cases()
    {
      const auto mg   = std::make_shared<MieGrueneisen>(aluminium);
      const auto poly = std::make_shared<LinearPolynomial>(LinearPolynomial::expansion_of(aluminium));
      return {
          {"aluminium", mg, 0.2839, solid_states},
          {"lead", std::make_shared<MieGrueneisen>(lead), 0.0421, solid_states},
          {"polynomial", poly, 0.2839, solid_states},
          {"polynomial, all six",
           std::make_shared<LinearPolynomial>(LinearPolynomial::Constants{2.7, 0.652, 0.5, 0.3, 2.0, 0.4, -0.7}),
           0.2415, solid_states},
          {"stiffened gas", std::make_shared<StiffenedGas>(StiffenedGas::Constants{1.0, 0.148, 4.4}), 0.0219,
           solid_states},
          {"ideal gas", std::make_shared<IdealGas>(1.4, 1.0), 1., gas_states},
      };
    }

    double
    pressure(const EquationOfState &eos, double true_density, double e)
    {
      double p, c2;
      eos.evaluate({&true_density, 1}, {&e, 1}, {&p, 1}, {&c2, 1});
      return p;
    }

    double
    sound_speed_squared(const EquationOfState &eos, double true_density, double e)
    {
      double p, c2;
      eos.evaluate({&true_density, 1}, {&e, 1}, {&p, 1}, {&c2, 1});
      return c2;
    }
  } // namespace

  TEST(EquationOfState, DerivativesMatchFiniteDifferences)
  {
    for (const Case &c : cases())
      for (const auto &[ratio, e] : c.states)
        {
          SCOPED_TRACE(c.label + " gamma/gamma0 " + std::to_string(ratio) + " e " + std::to_string(e));
          const double true_density = ratio * c.eos->reference_density();
          const double h = 1e-5 * true_density, k = 1e-5 * (0.01 + e);
          const double by_density =
              (pressure(*c.eos, true_density + h, e) - pressure(*c.eos, true_density - h, e)) / (2. * h);
          const double by_e =
              (pressure(*c.eos, true_density, e + k) - pressure(*c.eos, true_density, e - k)) / (2. * k);

          double dp_ddensity, dp_de;
          c.eos->derivatives({&true_density, 1}, {&e, 1}, {&dp_ddensity, 1}, {&dp_de, 1});
          const double scale = 1e-7 * (c.stiffness + std::abs(by_density));
          EXPECT_NEAR(dp_ddensity, by_density, scale);
          EXPECT_NEAR(dp_de, by_e, 1e-7 * std::abs(by_e));

          const double c2 = by_density + pressure(*c.eos, true_density, e) / (true_density * true_density) * by_e;
          EXPECT_NEAR(sound_speed_squared(*c.eos, true_density, e), c2,
                      1e-7 * (c.stiffness + std::abs(c2) + by_density));
        }
  }

  TEST(EquationOfState, EnergyOfPressureIsTheInverse)
  {
    for (const Case &c : cases())
      for (const auto &[ratio, e] : c.states)
        {
          SCOPED_TRACE(c.label + " gamma/gamma0 " + std::to_string(ratio) + " e " + std::to_string(e));
          const double true_density = ratio * c.eos->reference_density();
          EXPECT_NEAR(c.eos->energy_of_pressure(true_density, pressure(*c.eos, true_density, e)), e,
                      1e-14 * (1. + c.stiffness + e));
        }
  }

  TEST(EquationOfState, SolidsAreUnstressedAtTheirReferenceDensity)
  {
    for (const Case &c : cases())
      {
        SCOPED_TRACE(c.label);
        if (c.eos->name() == "ideal gas")
          continue;
        EXPECT_EQ(pressure(*c.eos, c.eos->reference_density(), 0.), 0.);
        EXPECT_NEAR(sound_speed_squared(*c.eos, c.eos->reference_density(), 0.), c.stiffness, 1e-3 * c.stiffness);
      }
  }

  TEST(MieGrueneisenLaw, PressureAndSoundSpeedAreContinuousAtTheReferenceDensity)
  {
    const MieGrueneisen eos(aluminium);
    const double        reference_density = eos.reference_density();
    for (const double e : {-0.002, 0., 0.01, 0.3})
      {
        const double above = reference_density * (1. + 1e-12), below = reference_density * (1. - 1e-12);
        EXPECT_NEAR(pressure(eos, above, e), pressure(eos, below, e), 1e-11);
        EXPECT_NEAR(sound_speed_squared(eos, above, e), sound_speed_squared(eos, below, e), 1e-10);
      }
  }

  TEST(MieGrueneisenLaw, IsUnstressedAtSomeDensityHoweverHot)
  {
    // 40 MJ/kg in lead: the linear law K mu + Gamma0 gamma0 e would still push in a vacuum.
    const MieGrueneisen eos(lead);
    for (const double e : {0.001, 0.0152, 0.05, 0.4})
      {
        EXPECT_GT(pressure(eos, eos.reference_density(), e), 0.);
        EXPECT_LT(pressure(eos, 1e-3 * eos.reference_density(), e), 0.);
      }
  }

  TEST(MieGrueneisenLaw, ExpansionStaysNearTheLinearLawWhereDebrisIs)
  {
    // Residual states of the 6.58 km/s case have gamma/gamma0 > 0.92: within 1 % of K mu there.
    const MieGrueneisen eos(aluminium);
    const double        bulk_modulus = 2.785 * 0.5328 * 0.5328;
    for (const double ratio : {0.999, 0.97, 0.92})
      EXPECT_NEAR(pressure(eos, 2.785 * ratio, 0.) / (bulk_modulus * (ratio - 1.)), 1., 0.01);
  }

  TEST(MieGrueneisenLaw, CompressionLimitIsTypedAndMonotoneBelow)
  {
    const MieGrueneisen eos(aluminium);
    const double        limit = 2.785 * 1.338 / 0.338; // 1 - gamma0/gamma = 1/s
    EXPECT_NEAR(eos.max_density(), limit, 1e-12 * limit);
    EXPECT_NO_THROW(eos.check_density(0.999 * limit));
    EXPECT_THROW(eos.check_density(1.001 * limit), StateError);
    EXPECT_THROW(eos.check_density(-1.), StateError);
    EXPECT_THROW(eos.check_density(std::nan("")), StateError);
    EXPECT_THROW(eos.energy_of_pressure(1.001 * limit, 1.), StateError);
    EXPECT_TRUE(std::isinf(MieGrueneisen({7.83, 0.3574, 0.9, 1.69}).max_density()));

    double last = 0.;
    for (double true_density = 2.785 * 1.001; true_density < 0.999 * limit; true_density *= 1.01)
      {
        EXPECT_GT(pressure(eos, true_density, 0.), last);
        last = pressure(eos, true_density, 0.);
      }
  }

  TEST(EquationOfState, BatchGivesTheBitsOfSingleCells)
  {
    // Remainder loops and vector loops must agree: every length, every offset.
    for (const Case &c : cases())
      {
        SCOPED_TRACE(c.label);
        std::vector<double> true_density, e;
        for (int i = 0; i < 37; ++i)
          {
            true_density.push_back(c.eos->reference_density() * (0.7 + 0.02137 * i));
            e.push_back(0.001 * ((i * 7) % 37));
          }
        std::vector<double> p(37), c2(37);
        for (std::size_t start = 0; start < 8; ++start)
          {
            const std::size_t n = true_density.size() - start;
            c.eos->evaluate(std::span<const double>(true_density).subspan(start),
                            std::span<const double>(e).subspan(start), std::span<double>(p).first(n),
                            std::span<double>(c2).first(n));
            for (std::size_t i = 0; i < n; ++i)
              {
                const double single   = pressure(*c.eos, true_density[start + i], e[start + i]);
                const double single_c = sound_speed_squared(*c.eos, true_density[start + i], e[start + i]);
                EXPECT_EQ(std::memcmp(&p[i], &single, sizeof(double)), 0);
                EXPECT_EQ(std::memcmp(&c2[i], &single_c, sizeof(double)), 0);
              }
          }
      }
  }

  TEST(LinearPolynomialLaw, The1993ConstantIsTheBulkModulus)
  {
    const LinearPolynomial eos({.reference_density = 2.7, .c1 = 0.652});
    EXPECT_NEAR(pressure(eos, 2.7 * 1.01, 0.5), 0.00652, 1e-15);
    EXPECT_NEAR(sound_speed_squared(eos, 2.7, 0.), 0.652 / 2.7, 1e-15);
    EXPECT_THROW(eos.energy_of_pressure(2.7, 0.1), StateError);
  }

  TEST(LinearPolynomialLaw, ExpansionHasThePublishedCoefficients)
  {
    // the expansion of the Mie-Grueneisen law, computed by hand to four digits
    const auto al = LinearPolynomial::expansion_of(aluminium);
    EXPECT_NEAR(al.c1, 0.7906, 5e-5);
    EXPECT_NEAR(al.c2, 0.5344, 5e-5);
    EXPECT_NEAR(al.c3, 0.2710, 5e-5);
    const auto cu = LinearPolynomial::expansion_of({8.93, 0.394, 1.489, 2.02});
    EXPECT_NEAR(cu.c1, 1.3863, 5e-5);
    EXPECT_NEAR(cu.c2, 1.3419, 5e-5);
    EXPECT_NEAR(cu.c3, 0.9809, 5e-5);

    // and so, near gamma0, is third-order close to the law it expands.
    const MieGrueneisen    full(aluminium);
    const LinearPolynomial expansion(al);
    const double           first  = pressure(full, 2.785 * 1.02, 0.) - pressure(expansion, 2.785 * 1.02, 0.);
    const double           second = pressure(full, 2.785 * 1.01, 0.) - pressure(expansion, 2.785 * 1.01, 0.);
    EXPECT_NEAR(first / second, 16., 1.);
  }

  TEST(IsothermalLaw, EnergyHasNoSay)
  {
    const auto                      solid = std::make_shared<MieGrueneisen>(aluminium);
    const IsothermalEquationOfState eos(solid);
    for (const double ratio : {0.9, 1., 1.3})
      {
        const double true_density = 2.785 * ratio, h = 1e-5 * true_density;
        EXPECT_EQ(pressure(eos, true_density, 0.05), pressure(*solid, true_density, 0.));
        const double slope =
            (pressure(*solid, true_density + h, 0.) - pressure(*solid, true_density - h, 0.)) / (2. * h);
        // At gamma0 the second derivative jumps, and the central difference is first order only.
        EXPECT_NEAR(sound_speed_squared(eos, true_density, 0.05), slope, ratio == 1. ? 1e-5 : 1e-8);
        EXPECT_EQ(eos.energy_of_pressure(true_density, pressure(*solid, true_density, 0.)), 0.);
      }
    EXPECT_THROW(eos.energy_of_pressure(2.785, 0.1), StateError);
    EXPECT_THROW(IsothermalEquationOfState(std::make_shared<IdealGas>(1.4, 1.)), InputError);
    EXPECT_THROW(IsothermalEquationOfState(nullptr), InputError);
  }

  TEST(EquationOfState, ImpossibleConstantsAreRejected)
  {
    const double nan = std::nan(""), infinity = INFINITY;
    EXPECT_THROW(IdealGas(1., 1.), InputError);
    EXPECT_THROW(IdealGas(1.4, -1.), InputError);
    EXPECT_THROW(IdealGas(nan, 1.), InputError);
    EXPECT_THROW(StiffenedGas({0., 0.1, 4.}), InputError);
    EXPECT_THROW(StiffenedGas({1., 0., 4.}), InputError);
    EXPECT_THROW(StiffenedGas({1., 0.1, 1.}), InputError);
    EXPECT_THROW(MieGrueneisen({-2.7, 0.5, 1.3, 2.}), InputError);
    EXPECT_THROW(MieGrueneisen({2.7, infinity, 1.3, 2.}), InputError);
    EXPECT_THROW(MieGrueneisen({2.7, 0.5, -1.3, 2.}), InputError);
    EXPECT_THROW(MieGrueneisen({2.7, 0.5, 1.3, 0.}), InputError);
    EXPECT_THROW(LinearPolynomial({.reference_density = 2.7, .c1 = 0.}), InputError);
    EXPECT_THROW(LinearPolynomial({.reference_density = 2.7, .c1 = 1., .c4 = nan}), InputError);
  }
} // namespace whipple
