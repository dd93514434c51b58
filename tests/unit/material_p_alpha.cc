// SPDX-License-Identifier: LGPL-2.1-or-later
// P-alpha compaction: the crush curve inverted independently, irreversibility, opening in tension, bits, bounds.
#include "../figure.h"

#include <whipple/error.h>
#include <whipple/material/equilibrium_void_law.h>
#include <whipple/material/linear_polynomial.h>
#include <whipple/material/mie_grueneisen.h>
#include <whipple/material/p_alpha_void_law.h>

#include <gtest/gtest.h>

#include <algorithm>
#include <cmath>
#include <cstring>
#include <numeric>
#include <random>
#include <vector>

namespace
{
  using namespace whipple;

  constexpr double reference_density = 2.7;
  constexpr double bulk_modulus      = 0.652;

  const LinearPolynomial linear({.reference_density = reference_density, .c1 = bulk_modulus});
  const MieGrueneisen    aluminium({2.785, 0.5328, 1.338, 2.0});

  constexpr PAlphaVoidLaw::Constants porous{0.3, 0.002, 0.02};

  double
  advanced(const VoidLaw &law, const EquationOfState &eos, double rho, double e, double phi)
  {
    law.advance(eos, 0.01, {{&rho, 1}, {&e, 1}, {}}, {&phi, 1});
    return phi;
  }

  double
  solid_pressure(const EquationOfState &eos, double true_density, double e)
  {
    double p, c2;
    eos.evaluate({&true_density, 1}, {&e, 1}, {&p, 1}, {&c2, 1});
    return p;
  }

  /// The quadratic crush curve [Herrmann1969], alpha of P.
  double
  crush_curve(const PAlphaVoidLaw::Constants &c, double bulk_pressure)
  {
    const double alpha0 = 1. / (1. - c.initial_porosity);
    const double share =
        (c.full_compaction_pressure - bulk_pressure) / (c.full_compaction_pressure - c.elastic_crush_pressure);
    return 1. + (alpha0 - 1.) * share * share;
  }

  /// Bulk density at which linear material of distension alpha has this bulk pressure: alpha rho = gamma0 (1 + alpha
  /// P/K).
  double
  density_on_curve(double alpha, double bulk_pressure)
  {
    return reference_density / alpha * (1. + alpha * bulk_pressure / bulk_modulus);
  }

  TEST(PAlphaCrush, FollowsTheCurveOfTheReferences)
  {
    const PAlphaVoidLaw law(porous);
    figure::Largest     error("alpha off the crush curve at 17 pressures, relative", "<= 1e-13");
    for (int i = 0; i <= 16; ++i)
      {
        const double pressure = 0.002 + i * (0.018 / 16.);
        const double alpha    = crush_curve(porous, pressure);
        const double phi      = advanced(law, linear, density_on_curve(alpha, pressure), 0., 0.3);
        EXPECT_NEAR(1. / (1. - phi), alpha, 1e-13);
        error(1. / ((1. - phi) * alpha) - 1.);
      }
    // half-way between P_e and P_c: alpha = 1 + (alpha0 - 1)/4 = 31/28 by hand, at rho = 2.48424613...
    EXPECT_NEAR(crush_curve(porous, 0.011), 31. / 28., 1e-15);
    EXPECT_NEAR(advanced(law, linear, 2.7 * 28. / 31. + 2.7 * 0.011 / 0.652, 0., 0.3), 3. / 31., 1e-13);
  }

  TEST(PAlphaCrush, ElasticBelowTheCurveAndClosedBeyondIt)
  {
    const PAlphaVoidLaw law(porous);
    const double        alpha0 = 1. / 0.7;
    for (const double pressure : {0., 0.001, 0.002 * (1. - 1e-9)})
      EXPECT_EQ(advanced(law, linear, density_on_curve(alpha0, pressure), 0., 0.3), 0.3);
    EXPECT_LT(advanced(law, linear, density_on_curve(alpha0, 0.002 * (1. + 1e-9)), 0., 0.3), 0.3);
    EXPECT_GT(advanced(law, linear, density_on_curve(1., 0.02 * (1. - 1e-9)), 0., 0.3), 0.);
    EXPECT_EQ(advanced(law, linear, density_on_curve(1., 0.02 * (1. + 1e-9)), 0., 0.3), 0.);
    EXPECT_EQ(advanced(law, linear, 1.3 * reference_density, 0., 0.3), 0.);
    // solid material stays solid, and its zero bits
    EXPECT_FALSE(std::signbit(advanced(law, linear, 1.01 * reference_density, 0., 0.)));
  }

  TEST(PAlphaCrush, IsIrreversible)
  {
    const PAlphaVoidLaw law(porous);
    const double        half = 0.011, alpha = crush_curve(porous, half);
    const double        crushed = advanced(law, linear, density_on_curve(alpha, half), 0., 0.3);
    // released, and pressed again to just below where it had been: no change of a bit
    for (const double pressure : {0.008, 0.001, 0., -0.004, 0.005, half * (1. - 1e-9)})
      EXPECT_EQ(advanced(law, linear, density_on_curve(alpha, pressure), 0., crushed), crushed);
    EXPECT_LT(advanced(law, linear, density_on_curve(alpha, half * 1.01), 0., crushed), crushed);
  }

  TEST(PAlphaCrush, HotMaterialLiesOnTheCurveWhateverTheStep)
  {
    // one large step or many small ones end on the same point of the curve
    const PAlphaVoidLaw law(porous);
    for (const double e : {0., 0.002, 0.01, 0.03})
      {
        const double start = 0.7 * 2.785;
        double       many  = 0.3;
        for (int i = 1; i <= 100; ++i)
          many = advanced(law, aluminium, start * (1. + 0.002 * i), e, many);
        const double once = advanced(law, aluminium, start * 1.2, e, 0.3);
        EXPECT_NEAR(once, many, 1e-13);
        if (once > 0.)
          {
            const double bulk = (1. - once) * solid_pressure(aluminium, start * 1.2 / (1. - once), e);
            EXPECT_NEAR(1. / (1. - once), crush_curve(porous, bulk), 1e-12) << e;
          }
      }
  }

  TEST(PAlphaTension, OpensBeyondTheSpallStrengthOnly)
  {
    PAlphaVoidLaw::Constants spalling = porous;
    spalling.spall_strength           = 0.012;
    const PAlphaVoidLaw law(spalling), never(porous);
    for (const double phi : {0., 0.1, 0.3})
      {
        const double at_strength = (1. - phi) * reference_density * (1. - 0.012 / bulk_modulus);
        EXPECT_EQ(advanced(law, linear, at_strength * (1. + 1e-9), 0., phi), phi);
        EXPECT_EQ(advanced(never, linear, 0.5 * at_strength, 0., phi), phi);
        const double open = advanced(law, linear, at_strength * (1. - 1e-9), 0., phi);
        EXPECT_GT(open, phi);
        EXPECT_NEAR(solid_pressure(linear, at_strength * (1. - 1e-9) / (1. - open), 0.), 0., 1e-14);
      }
    // soundness: half of the strength, none, and none of an infinite one
    const double rho = reference_density * (1. - 0.009 / bulk_modulus), e = 0.;
    for (const auto &[model, kept, opens] : {std::tuple{&law, 0.7, true}, std::tuple{&law, 0.8, false},
                                             std::tuple{&never, 0.1, false}, std::tuple{&never, 0., true}})
      {
        double phi = 0.;
        model->advance(linear, 0.01, {{&rho, 1}, {&e, 1}, {&kept, 1}}, {&phi, 1});
        EXPECT_EQ(phi > 0., opens) << kept;
      }
  }

  TEST(PAlphaTension, LooseMaterialClosesToItsPorosityAndThenCrushes)
  {
    const PAlphaVoidLaw law(porous);
    // no resistance while looser than phi0: P_s = 0 at 0.65 gamma0
    EXPECT_NEAR(advanced(law, linear, 0.65 * reference_density, 0., 0.5), 0.35, 1e-14);
    // the elastic range at phi0
    EXPECT_EQ(advanced(law, linear, density_on_curve(1. / 0.7, 0.001), 0., 0.5), 0.3);
    // and the curve, as if it had never been loose
    const double rho = density_on_curve(crush_curve(porous, 0.011), 0.011);
    EXPECT_EQ(advanced(law, linear, rho, 0., 0.5), advanced(law, linear, rho, 0., 0.3));
    // stretched further it opens without a threshold
    EXPECT_NEAR(advanced(law, linear, 0.5 * reference_density, 0., 0.35), 0.5, 1e-14);
    // phi0 that a remap has rounded is not loose
    const double rounded = 0.3 * (1. + 1e-15);
    EXPECT_EQ(advanced(law, linear, 0.69 * reference_density, 0., rounded), rounded);
  }

  struct Cells
  {
    std::vector<double> rho, e, phi, soundness;
  };

  Cells
  random_cells(std::size_t n)
  {
    std::mt19937                           generator(4);
    std::uniform_real_distribution<double> uniform(0., 1.);
    Cells                                  cells;
    for (std::size_t i = 0; i < n; ++i)
      {
        const double kind = uniform(generator), x = uniform(generator);
        const double phi = kind < 0.2 ? 0. : kind < 0.7 ? 0.3 * x : kind < 0.9 ? x : 1. - std::pow(10., -12. * x);
        cells.phi.push_back(phi);
        cells.rho.push_back((1. - phi) * 2.785 * (0.8 + 0.5 * uniform(generator)));
        cells.e.push_back(0.05 * uniform(generator) * uniform(generator));
        cells.soundness.push_back(std::max(0., 1.5 * uniform(generator) - 0.5));
      }
    return cells;
  }

  TEST(PAlphaLimits, BoundedMonotoneAndOnTheCurveForRandomStates)
  {
    PAlphaVoidLaw::Constants spalling = porous;
    spalling.spall_strength           = 0.012;
    const PAlphaVoidLaw law(spalling);
    const Cells         cells = random_cells(20000);
    Cells               next  = cells;
    law.advance(aluminium, 1e3, {next.rho, next.e, next.soundness}, next.phi);
    figure::Largest off("bulk pressure off the crush curve, 20000 random states, relative to P_c", "<= 1e-12");
    int             on_curve = 0;
    for (std::size_t i = 0; i < cells.rho.size(); ++i)
      {
        SCOPED_TRACE(i);
        const double phi = next.phi[i], old = cells.phi[i];
        ASSERT_TRUE(phi >= 0. && phi < 1.);
        const double before = solid_pressure(aluminium, std::min(cells.rho[i] / (1. - old), 10.), cells.e[i]);
        const double after  = solid_pressure(aluminium, cells.rho[i] / (1. - phi), cells.e[i]);
        ASSERT_TRUE(before > 0. ? phi <= old : phi >= old);
        if (phi > 0. && phi != old && phi < 0.3)
          {
            const double x     = std::sqrt(phi / (1. - phi) * (0.7 / 0.3));
            const double curve = 0.02 - 0.018 * x;
            off(before > 0. ? ((1. - phi) * after - curve) / 0.02 : 0.);
            on_curve += before > 0. ? 1 : 0;
            ASSERT_TRUE(before <= 0. || std::abs((1. - phi) * after - curve) <= 1e-12 * 0.02 / (1. - phi));
          }
      }
    EXPECT_GT(on_curve, 500);
  }

  TEST(PAlphaLimits, NothingAndNonsenseAreLeftAlone)
  {
    const double        nan = std::nan("");
    std::vector<double> rho = {0., -1., 2.2, nan, 2.2}, e = {0., 0., nan, 0., 0.}, phi = {0.3, 0.3, 0.3, 0.3, 0.3};
    PAlphaVoidLaw(porous).advance(aluminium, 0.01, {rho, e, {}}, phi);
    for (std::size_t i = 0; i < 4; ++i)
      EXPECT_EQ(phi[i], 0.3);
    EXPECT_LT(phi[4], 0.3);
  }

  TEST(PAlphaLimits, CompressionBeyondThePoleOfTheHugoniotStillCrushes)
  {
    // the old pores would need gamma above max_density()
    const PAlphaVoidLaw strong({0.9, 0.002, 2.});
    const double        phi = advanced(strong, aluminium, 2.5, 0., 0.9);
    EXPECT_GT(phi, 0.);
    const double bulk = (1. - phi) * solid_pressure(aluminium, 2.5 / (1. - phi), 0.);
    EXPECT_NEAR(1. / (1. - phi), crush_curve({0.9, 0.002, 2.}, bulk), 1e-12);
    EXPECT_EQ(advanced(strong, aluminium, 12., 0., 0.9), 0.);
  }

  TEST(PAlphaBits, DoNotDependOnThePlaceInTheArray)
  {
    PAlphaVoidLaw::Constants spalling = porous;
    spalling.spall_strength           = 0.012;
    const PAlphaVoidLaw law(spalling);
    const std::size_t   n         = 3000;
    const Cells         cells     = random_cells(n);
    Cells               reference = cells;
    law.advance(aluminium, 0.01, {reference.rho, reference.e, {}}, reference.phi);

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
    const std::vector<double> all(n, 1.);
    law.advance(aluminium, 0.01, {shuffled.rho, shuffled.e, all}, shuffled.phi);
    for (std::size_t i = 0; i < n; ++i)
      {
        const double alone = advanced(law, aluminium, cells.rho[i], cells.e[i], cells.phi[i]);
        ASSERT_EQ(std::memcmp(&alone, &reference.phi[i], sizeof(double)), 0) << i;
        ASSERT_EQ(std::memcmp(&shuffled.phi[i], &reference.phi[order[i]], sizeof(double)), 0) << i;
      }
  }

  TEST(PAlphaInput, ImpossibleConstantsAreRejected)
  {
    EXPECT_THROW(PAlphaVoidLaw({0., 0.002, 0.02}), InputError);
    EXPECT_THROW(PAlphaVoidLaw({1., 0.002, 0.02}), InputError);
    EXPECT_THROW(PAlphaVoidLaw({0.3, -0.002, 0.02}), InputError);
    EXPECT_THROW(PAlphaVoidLaw({0.3, 0.02, 0.02}), InputError);
    EXPECT_THROW(PAlphaVoidLaw({0.3, 0.002, 0.02, -1.}), InputError);
    EXPECT_NO_THROW(PAlphaVoidLaw({0.3, 0., 0.02, 0.}));
    EXPECT_EQ(PAlphaVoidLaw(porous).initial_void_fraction(), 0.3);
    EXPECT_EQ(EquilibriumVoidLaw(0.).initial_void_fraction(), 0.);
  }
} // namespace
