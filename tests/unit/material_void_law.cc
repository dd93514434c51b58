// SPDX-License-Identifier: LGPL-2.1-or-later
// The void laws against the exact solution of the rate law and against what they promise for any alpha.
#include "../figure.h"

#include <whipple/error.h>
#include <whipple/exact/void_rate.h>
#include <whipple/material/equilibrium_void_law.h>
#include <whipple/material/ideal_gas.h>
#include <whipple/material/linear_polynomial.h>
#include <whipple/material/mie_grueneisen.h>
#include <whipple/material/rate_void_law.h>

#include <gtest/gtest.h>

#include <algorithm>
#include <cmath>
#include <cstring>
#include <numeric>
#include <random>
#include <vector>

namespace whipple
{
  namespace
  {
    constexpr double reference_density = 2.7;
    constexpr double bulk_modulus      = 0.652;

    const LinearPolynomial linear({.reference_density = reference_density, .c1 = bulk_modulus});
    const MieGrueneisen    aluminium({2.785, 0.5328, 1.338, 2.0});
    const double           alphas[] = {1e-2, 1e-1, 1., 1e1, 1e2, 1e3, 1e5, 1e7, 1e9};

    double
    advanced(const VoidLaw &law, const EquationOfState &eos, double dt, double rho, double e, double phi)
    {
      law.advance(eos, dt, {{&rho, 1}, {&e, 1}, {}}, {&phi, 1});
      return phi;
    }

    double
    pressure(const EquationOfState &eos, double true_density, double e)
    {
      double p, c2;
      eos.evaluate({&true_density, 1}, {&e, 1}, {&p, 1}, {&c2, 1});
      return p;
    }

    /// phi after `steps` equal steps of the law over the dimensionless time lambda t = 1.
    double
    phi_after_one_relaxation_time(double alpha, double rho, double phi, int steps)
    {
      const RateVoidLaw law(alpha, 0.);
      const double      dt = reference_density / (alpha * bulk_modulus) / steps;
      for (int i = 0; i < steps; ++i)
        phi = advanced(law, linear, dt, rho, 0., phi);
      return phi;
    }

    struct Cells
    {
      std::vector<double> rho, e, phi;
    };

    /// Sound, spalling, distended, compressed and nearly empty aluminium, some of it hot.
    Cells
    random_cells(std::size_t n)
    {
      std::mt19937                           generator(2);
      std::uniform_real_distribution<double> uniform(0., 1.);
      Cells                                  cells;
      for (std::size_t i = 0; i < n; ++i)
        {
          const double kind = uniform(generator), x = uniform(generator);
          const double phi = kind < 0.3 ? 0. : kind < 0.9 ? x : 1. - std::pow(10., -12. * x);
          cells.phi.push_back(phi);
          cells.rho.push_back((1. - phi) * 2.785 * (0.7 + 0.6 * uniform(generator)));
          cells.e.push_back(0.05 * uniform(generator) * uniform(generator));
        }
      return cells;
    }
  } // namespace

  TEST(RateVoidLawExact, ConvergesWithFirstOrderForEveryAlpha)
  {
    figure::Largest error("relative error of phi, 128 steps over a relaxation time, alpha 1e-2 .. 1e9", "converges");
    figure::Largest order("error of 64 / error of 128 steps, off 2, alpha 1e-2 .. 1e9", "<= 0.06");
    // Tension and compression of distended material, mild and strong.
    for (const double g0 : {0.9, 0.995, 1.005, 1.2})
      for (const double alpha : alphas)
        {
          SCOPED_TRACE("g0 " + std::to_string(g0) + " alpha " + std::to_string(alpha));
          const double phi0  = 0.3;
          const double rho   = (1. - phi0) * g0 * reference_density;
          const double exact = exact::VoidRate({reference_density, bulk_modulus, alpha, rho, phi0})
                                   .void_fraction(reference_density / (alpha * bulk_modulus));
          const double coarse = std::abs(phi_after_one_relaxation_time(alpha, rho, phi0, 64) - exact);
          const double fine   = std::abs(phi_after_one_relaxation_time(alpha, rho, phi0, 128) - exact);
          order(coarse / fine - 2.);
          error(fine / std::abs(exact - phi0));
          EXPECT_NEAR(coarse / fine, 2., 0.06);
          EXPECT_LT(fine, 0.01 * std::abs(exact - phi0));
        }
  }

  TEST(RateVoidLawExact, OneStepSolvesTheBackwardEulerEquation)
  {
    // (phi - phi_old) gamma0^2 / (alpha rho dt) + P_s = 0 unless phi = 0, at steps of hydrodynamics.
    const double dt    = 0.004;
    const Cells  cells = random_cells(2000);
    for (const double alpha : alphas)
      {
        const RateVoidLaw law(alpha, 0.012);
        for (std::size_t i = 0; i < cells.rho.size(); ++i)
          {
            const double rho = cells.rho[i], e = cells.e[i], old = cells.phi[i];
            const double phi = advanced(law, aluminium, dt, rho, e, old);
            if (phi == 0. || phi == old || 1. - phi < 1e-9)
              continue;
            // Both sides are known to rounding of phi: of 1 - phi in gamma, of the difference in the rate.
            const double true_density = rho / (1. - phi);
            const double rate         = alpha * rho * dt / (2.785 * 2.785);
            const double rounding     = 1e-14 * (1. + rate * 2. / (1. - phi));
            EXPECT_NEAR(phi - old, -rate * pressure(aluminium, true_density, e), rounding) << alpha << " " << i;
          }
      }
  }

  TEST(RateVoidLawStability, AnyStepIsMonotoneAndBounded)
  {
    const Cells cells = random_cells(2000);
    for (const double alpha : {1e-2, 1., 1e3, 1e9, static_cast<double>(INFINITY)})
      for (const double dt : {1e-6, 1e-3, 1., 1e3})
        {
          const RateVoidLaw law(alpha, 0.);
          Cells             next = cells;
          law.advance(aluminium, dt, {next.rho, next.e, {}}, next.phi);
          for (std::size_t i = 0; i < cells.rho.size(); ++i)
            {
              SCOPED_TRACE("alpha " + std::to_string(alpha) + " dt " + std::to_string(dt) + " cell " +
                           std::to_string(i));
              const double before = pressure(aluminium, cells.rho[i] / (1. - cells.phi[i]), cells.e[i]);
              const double after  = pressure(aluminium, cells.rho[i] / (1. - next.phi[i]), cells.e[i]);
              ASSERT_GE(next.phi[i], 0.);
              ASSERT_LT(next.phi[i], 1.);
              // Voids move against the pressure and never past equilibrium (but for the rounding of 1 - phi).
              const double rounding = 4e-16 / (1. - next.phi[i]);
              if (before > 0.)
                {
                  ASSERT_LE(next.phi[i], cells.phi[i]);
                  ASSERT_GE(after, -rounding);
                  ASSERT_LE(after, before);
                }
              else
                {
                  ASSERT_GE(next.phi[i], cells.phi[i]);
                  ASSERT_LE(after, rounding);
                  ASSERT_GE(after, before);
                }
            }
        }
  }

  TEST(RateVoidLawStability, LargeAlphaTendsToEquilibrium)
  {
    const double rho = 0.6 * 2.785, e = 0.01;
    const double equilibrium = advanced(EquilibriumVoidLaw(0.), aluminium, 0.004, rho, e, 0.3);
    figure::record("pressure at alpha = infinity, Mbar", pressure(aluminium, rho / (1. - equilibrium), e), "0");
    EXPECT_NEAR(pressure(aluminium, rho / (1. - equilibrium), e), 0., 1e-15);
    double last = INFINITY;
    for (const double alpha : {1e3, 1e5, 1e7, 1e9})
      {
        const double off = std::abs(advanced(RateVoidLaw(alpha, 0.), aluminium, 0.004, rho, e, 0.3) - equilibrium);
        EXPECT_LT(off, 0.5 * last);
        last = off;
      }
    figure::record("phi at alpha 1e9 off equilibrium", last, "<= 1e-6");
    EXPECT_LT(last, 1e-6);
    EXPECT_EQ(advanced(RateVoidLaw(INFINITY, 0.), aluminium, 0.004, rho, e, 0.3), equilibrium);
  }

  TEST(RateVoidLawStability, ZeroAlphaOrZeroTimeChangesNothing)
  {
    const Cells cells = random_cells(500);
    Cells       next  = cells;
    RateVoidLaw(0., 0.).advance(aluminium, 0.004, {next.rho, next.e, {}}, next.phi);
    RateVoidLaw(1e3, 0.).advance(aluminium, 0., {next.rho, next.e, {}}, next.phi);
    EXPECT_EQ(next.phi, cells.phi);
  }

  TEST(VoidClosure, CompressedSoundMaterialKeepsItsZeroBits)
  {
    std::vector<double> rho, e, phi(1000, 0.);
    for (int i = 0; i < 1000; ++i)
      {
        rho.push_back(2.785 * (1. + 0.0007 * i));
        e.push_back(1e-5 * i);
      }
    RateVoidLaw(1e9, 0.).advance(aluminium, 0.01, {rho, e, {}}, phi);
    EquilibriumVoidLaw(0.).advance(aluminium, 0.01, {rho, e, {}}, phi);
    const std::vector<double> zeros(1000, 0.);
    EXPECT_EQ(std::memcmp(phi.data(), zeros.data(), 1000 * sizeof(double)), 0);
  }

  TEST(VoidClosure, PoresUnderCompressionCloseToExactlyZero)
  {
    // rho > gamma0: no equilibrium with voids. In the exact solution g falls from g0 to rho/gamma0 in finite time.
    const double phi0 = 0.02, rho = 1.05 * reference_density, g0 = rho / reference_density / (1. - phi0);
    const double alpha      = 100.;
    const auto   clock      = [](double g) { return std::log((g - 1.) / g) + 1. / g; };
    const double close_time = (clock(g0) - clock(rho / reference_density)) * reference_density / (alpha * bulk_modulus);
    const int    steps      = 400;
    const double dt         = 2. * close_time / steps;
    double       phi        = phi0;
    int          closed     = 0;
    for (int i = 0; i < steps; ++i)
      {
        phi = advanced(RateVoidLaw(alpha, 0.), linear, dt, rho, 0., phi);
        closed += phi == 0.;
      }
    EXPECT_EQ(phi, 0.);
    EXPECT_NEAR(closed, steps / 2, steps / 100);
    EXPECT_EQ(advanced(EquilibriumVoidLaw(0.), linear, dt, rho, 0., phi0), 0.);
  }

  TEST(SpallThreshold, OpensOnlyBeyondTheStrengthAndThenForgetsIt)
  {
    const double      strength = 0.012;
    const RateVoidLaw law(100., strength);
    const double      at_strength = reference_density * (1. - strength / bulk_modulus);
    EXPECT_EQ(advanced(law, linear, 0.005, at_strength * (1. + 1e-6), 0., 0.), 0.);
    const double opened = advanced(law, linear, 0.005, at_strength * (1. - 1e-6), 0., 0.);
    EXPECT_GT(opened, 0.);

    // Relieved to a tension far below the strength, the same material goes on opening: hysteresis.
    const double rho = (1. - opened) * reference_density * (1. - 0.1 * strength / bulk_modulus);
    EXPECT_GT(advanced(law, linear, 0.005, rho, 0., opened), opened);
    EXPECT_EQ(advanced(law, linear, 0.005, rho, 0., 0.), 0.);

    // Closed again by compression, it is sound again and the threshold is back.
    EXPECT_EQ(advanced(law, linear, 0.1, 1.01 * reference_density, 0., opened), 0.);
    EXPECT_EQ(advanced(RateVoidLaw(INFINITY, INFINITY), linear, 1., 0.1 * reference_density, 0., 0.), 0.);
  }

  TEST(SpallThreshold, SoundnessScalesItCellByCell)
  {
    const double strength = 0.012;
    for (const double kept : {1., 0.5, 0.1, 0.})
      for (const double side : {1e-6, -1e-6})
        {
          const double rho = reference_density * (1. - kept * strength / bulk_modulus + side), e = 0.;
          double       phi = 0.;
          EquilibriumVoidLaw(strength).advance(linear, 0.01, {{&rho, 1}, {&e, 1}, {&kept, 1}}, {&phi, 1});
          EXPECT_EQ(phi > 0., side < 0.) << kept;
        }
    // an infinite strength of which nothing is left is none; of which something is left, infinite
    const std::vector<double> soundness = {0., 1e-3}, rho(2, 0.99 * reference_density), e(2, 0.);
    std::vector<double>       phi(2, 0.);
    EquilibriumVoidLaw(INFINITY).advance(linear, 0.01, {rho, e, soundness}, phi);
    EXPECT_NEAR(phi[0], 0.01, 1e-15);
    EXPECT_EQ(phi[1], 0.);
  }

  TEST(SpallThreshold, AllOfTheSoundnessLeavesTheBits)
  {
    const Cells               cells = random_cells(2000);
    const std::vector<double> all(2000, 1.);
    Cells                     with = cells, without = cells;
    RateVoidLaw(1e3, 0.012).advance(aluminium, 0.004, {with.rho, with.e, all}, with.phi);
    RateVoidLaw(1e3, 0.012).advance(aluminium, 0.004, {without.rho, without.e, {}}, without.phi);
    EXPECT_EQ(std::memcmp(with.phi.data(), without.phi.data(), 2000 * sizeof(double)), 0);
  }

  TEST(VoidLimits, NearlyEmptyCellsConvergeBelowOne)
  {
    for (const double rho : {1e-6, 1e-12, 1e-18, 1e-30, 1e-60})
      for (const double start : {0., 0.5, 1. - 1e-12})
        for (const double e : {0., 0.01, 0.2})
          {
            SCOPED_TRACE(std::to_string(std::log10(rho)) + " " + std::to_string(start));
            const double phi = advanced(EquilibriumVoidLaw(0.), aluminium, 0.01, rho, e, start);
            EXPECT_LT(phi, 1.);
            EXPECT_GE(phi, 0.);
            if (rho > 1e-9) // below, 1 - phi holds too few bits for P_s = 0
              {
                EXPECT_NEAR(pressure(aluminium, rho / (1. - phi), e), 0., 1e-9);
              }
            const double slow = advanced(RateVoidLaw(1., 0.), aluminium, 0.01, rho, e, start);
            EXPECT_LT(slow, 1.);
            EXPECT_GE(slow, 0.);
          }
  }

  TEST(VoidLimits, NothingAndNonsenseAreLeftAlone)
  {
    const double        nan = std::nan("");
    std::vector<double> rho = {0., -1., 1., nan, 2.}, e = {0., 0., nan, 0., 0.}, phi = {0.5, 0.25, 0.5, 0.5, 0.1};
    const auto          before = phi;
    EquilibriumVoidLaw(0.).advance(aluminium, 0.01, {rho, e, {}}, phi);
    for (std::size_t i = 0; i < 4; ++i)
      EXPECT_EQ(phi[i], before[i]);
    EXPECT_GT(phi[4], 0.1);
  }

  TEST(VoidLimits, AGasClosesItsVoids)
  {
    const IdealGas gas(1.4, 1.);
    EXPECT_EQ(advanced(EquilibriumVoidLaw(0.), gas, 0.01, 0.5, 1., 0.5), 0.);
  }

  TEST(VoidLimits, CompressionBeyondThePoleOfTheHugoniotStillRelaxes)
  {
    // Pores crushed within one step: gamma of the old phi lies above max_density(), the equilibrium does not.
    const double phi = advanced(EquilibriumVoidLaw(0.), aluminium, 0.01, 1.2, 0.01, 0.93);
    EXPECT_NEAR(pressure(aluminium, 1.2 / (1. - phi), 0.01), 0., 1e-14);
  }

  TEST(VoidLawBits, DoNotDependOnThePlaceInTheArray)
  {
    const std::size_t n     = 3000;
    const Cells       cells = random_cells(n);
    for (const double alpha : {1., 1e3, static_cast<double>(INFINITY)})
      {
        const RateVoidLaw law(alpha, 0.012);
        Cells             reference = cells;
        law.advance(aluminium, 0.004, {reference.rho, reference.e, {}}, reference.phi);

        std::vector<std::size_t> order(n);
        std::iota(order.begin(), order.end(), 0);
        std::shuffle(order.begin(), order.end(), std::mt19937(7));
        Cells shuffled = cells;
        for (std::size_t i = 0; i < n; ++i)
          {
            shuffled.rho[i] = cells.rho[order[i]];
            shuffled.e[i]   = cells.e[order[i]];
            shuffled.phi[i] = cells.phi[order[i]];
          }
        law.advance(aluminium, 0.004, {shuffled.rho, shuffled.e, {}}, shuffled.phi);
        for (std::size_t i = 0; i < n; ++i)
          ASSERT_EQ(std::memcmp(&shuffled.phi[i], &reference.phi[order[i]], sizeof(double)), 0);

        for (std::size_t i = 0; i < n; i += 7)
          {
            const double alone = advanced(law, aluminium, 0.004, cells.rho[i], cells.e[i], cells.phi[i]);
            ASSERT_EQ(std::memcmp(&alone, &reference.phi[i], sizeof(double)), 0);
          }
      }
  }

  TEST(VoidLawInput, ImpossibleParametersAreRejected)
  {
    EXPECT_THROW(RateVoidLaw(-1., 0.), InputError);
    EXPECT_THROW(RateVoidLaw(std::nan(""), 0.), InputError);
    EXPECT_THROW(RateVoidLaw(1., -0.01), InputError);
    EXPECT_THROW(EquilibriumVoidLaw(-0.01), InputError);
    EXPECT_NO_THROW(RateVoidLaw(INFINITY, INFINITY));
  }

  /// A stage with a void growth coefficient of its own has the law of that, and no other.
  TEST(VoidLaw, WithAnotherGrowthCoefficient)
  {
    const MieGrueneisen eos({2.785, 0.535, 1.34, 2.});
    const RateVoidLaw   law(1000., 0.001), other(0.1, 0.001);
    const auto          changed = law.with_growth(0.1);
    ASSERT_TRUE(changed);
    EXPECT_EQ(changed->yielding(eos), other.yielding(eos));
    const std::vector<double> density{2.6}, energy{0.001};
    std::vector<double>       phi{0.01}, expected{0.01};
    changed->advance(eos, 0.1, {density, energy, {}}, phi);
    other.advance(eos, 0.1, {density, energy, {}}, expected);
    EXPECT_EQ(phi, expected);
    EXPECT_NE(phi[0], 0.01);
    EXPECT_FALSE(EquilibriumVoidLaw(0.001).with_growth(0.1));
  }
} // namespace whipple
