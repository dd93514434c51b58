// SPDX-License-Identifier: LGPL-2.1-or-later
// Tillotson's law: published formulas by hand, joins, contract of an equation of state, voids. Shock and release are
// in material_hugoniot.cc.
#include "equation_of_state_check.h"

#include <whipple/material/model_registry.h>
#include <whipple/material/tillotson.h>
#include <whipple/material/void_relaxation.h>

namespace whipple
{
  namespace
  {
    using namespace eos_check;

    const Tillotson::Constants aluminium{2.70, 0.5, 1.63, 0.752, 0.65, 0.05, 5., 5., 0.03, 0.139};

    std::vector<Tillotson::Constants>
    published()
    {
      std::vector<Tillotson::Constants> result;
      for (const auto &row : ModelRegistry<EquationOfState>::all().at("tillotson").description.published)
        {
          const auto c = [&](const std::string &key) { return row.constants.at(key); };
          result.push_back({c("Density"), c("Tillotson hot Grueneisen coefficient"),
                            c("Tillotson cold Grueneisen coefficient"), c("Tillotson bulk modulus"),
                            c("Tillotson quadratic modulus"), c("Tillotson reference energy"),
                            c("Tillotson thermal decay"), c("Tillotson cohesive decay"),
                            c("Tillotson incipient vaporisation energy"), c("Tillotson complete vaporisation energy")});
        }
      return result;
    }

    /// Shocked, released, molten and expanded, cold tension, joint of both branches, vapour, nearly void.
    std::vector<State>
    states(const Tillotson::Constants &k)
    {
      const double              iv = k.incipient_vaporisation_energy, cv = k.complete_vaporisation_energy;
      std::vector<State>        result;
      const std::vector<double> ratios{1.7, 1.4, 1.1, 1.01, 0.98, 0.9, 0.7, 0.4, 0.15};
      for (const double ratio : ratios)
        for (const double e : {-0.1 * iv, 0.05 * iv, 0.6 * iv, 1.1 * iv, 0.5 * (iv + cv), 0.95 * cv, 1.2 * cv, 4. * cv})
          result.push_back({ratio * k.reference_density, e});
      return result;
    }
  } // namespace

  TEST(TillotsonLaw, BranchesByHand)
  {
    const Tillotson eos(aluminium);
    // gamma 3.24 (eta 1.2), e 0.02: w = 1 + 0.02/(0.05 1.44) = 1.2777..., P = (0.5 + 1.63/w) 0.0648 + 0.1504 + 0.026
    EXPECT_NEAR(pressure(eos, 3.24, 0.02), (0.5 + 1.63 / 1.2777777777777778) * 0.0648 + 0.1764, 1e-15);
    // gamma 2.43 (eta 0.9), cold: -0.0752/(1 + 0.1 0.65/0.752), near A mu + B mu^2
    EXPECT_NEAR(pressure(eos, 2.43, 0.), -0.0752 / 1.0864361702127659, 1e-15);
    EXPECT_NEAR(pressure(eos, 2.673, 0.), -0.00752 + 0.65e-4, 1e-6);
    // gamma 1.35 (eta 0.5, z 1), e 0.2 above E_cv: w = 1 + 0.2/(0.05 0.25) = 17
    const double bracket = 1.63 * 0.27 / 17. - 0.376 * std::exp(-5.);
    EXPECT_NEAR(pressure(eos, 1.35, 0.2), 0.135 + bracket * std::exp(-5.), 1e-15);
    // Half way between E_iv and E_cv: the mean of both, as in the linear original.
    const double w    = 1. + 0.0845 / 0.0125;
    const double cold = (0.5 + 1.63 / w) * 1.35 * 0.0845 - 0.376 / (1. + 0.5 * 0.65 / 0.752);
    const double hot  = 0.5 * 1.35 * 0.0845 + (1.63 * 1.35 * 0.0845 / w - 0.376 * std::exp(-5.)) * std::exp(-5.);
    EXPECT_NEAR(pressure(eos, 1.35, 0.0845), 0.5 * (cold + hot), 1e-15);
    EXPECT_NEAR(sound_speed_squared(eos, 2.70, 0.), 0.752 / 2.70, 1e-15);
  }

  TEST(TillotsonLaw, DerivativesAreThoseOfThePressure)
  {
    for (const Tillotson::Constants &k : published())
      for (const State &state : states(k))
        expect_exact_derivatives(Tillotson(k), state, k.incipient_vaporisation_energy, 1e-8);
  }

  TEST(TillotsonLaw, PressureAndSoundSpeedHaveNoJump)
  {
    for (const Tillotson::Constants &k : published())
      {
        const Tillotson eos(k);
        const double    d  = 1e-12;
        const auto      at = [&](double density1, double e1, double density2, double e2) {
          SCOPED_TRACE("density " + std::to_string(density1) + " e " + std::to_string(e1));
          EXPECT_NEAR(pressure(eos, density1, e1), pressure(eos, density2, e2), 1e-7 * k.bulk_modulus);
          EXPECT_NEAR(sound_speed_squared(eos, density1, e1), sound_speed_squared(eos, density2, e2),
                           1e-6 * k.bulk_modulus / k.reference_density);
        };
        const double iv = k.incipient_vaporisation_energy, cv = k.complete_vaporisation_energy;
        for (const double e : {-0.5 * iv, 0., 0.5 * iv, 0.5 * (iv + cv), 2. * cv})
          at(k.reference_density * (1. + d), e, k.reference_density * (1. - d), e);
        for (const double ratio : {0.95, 0.7, 0.3, 0.05})
          for (const double e : {0., iv, cv})
            at(ratio * k.reference_density, e + d * cv, ratio * k.reference_density, e - d * cv);
      }
  }

  TEST(TillotsonLaw, IsentropesAndInverse)
  {
    const Tillotson eos(aluminium);
    expect_isentropic(eos, {4.0, 0.054}, 2.5, 1500, 1e-9); // shocked at 6.58 km/s, released
    expect_isentropic(eos, {4.6, 0.125}, 1.2, 3400, 1e-8); // far expanded, through both joints
    expect_isentropic(eos, {2.7, 0.}, 2.3, 400, 1e-9);     // cold tension
    for (const State &state : states(aluminium))
      expect_inverse(eos, state, 0.03, 1e-13);
    EXPECT_THROW(eos.energy_of_pressure(-1., 0.1), StateError);
  }

  TEST(TillotsonLaw, BatchGivesTheBitsOfSingleCells)
  {
    expect_batch_is_scalar(Tillotson(aluminium), states(aluminium));
  }

  TEST(TillotsonLaw, CondensedMaterialIsMonotoneAndInTensionWhenDistended)
  {
    for (const Tillotson::Constants &k : published())
      for (const double share : {-0.1, 0., 0.3, 1.})
        {
          const Tillotson eos(k);
          const double    e    = share * k.incipient_vaporisation_energy;
          double          last = -k.bulk_modulus;
          for (double ratio = 1e-3; ratio < 3.; ratio *= 1.01)
            {
              const double p = pressure(eos, ratio * k.reference_density, e);
              EXPECT_GT(p, last) << ratio;
              last = p;
            }
          EXPECT_LT(pressure(eos, 0.1 * k.reference_density, e), 0.);
        }
  }

  TEST(TillotsonLaw, VapourPushesAtEveryDensity)
  {
    for (const Tillotson::Constants &k : published())
      for (const double share : {1.01, 2., 10.})
        for (double ratio = 1e-4; ratio < 1.; ratio *= 1.02)
          EXPECT_GT(pressure(Tillotson(k), ratio * k.reference_density, share * k.complete_vaporisation_energy), 0.)
              << k.reference_density << " " << ratio;
  }

  TEST(TillotsonLaw, VoidsOpenInTensionAndCloseUnderVapour)
  {
    const Tillotson eos(aluminium);
    // Distended and cold; distended and molten; vapour; the joint, where P(gamma) has three roots.
    const std::vector<double> rho{1.35, 1.35, 0.3, 0.3}, e{0., 0.011, 0.2, 0.06};
    std::vector<double>       phi{0., 0., 0.5, 0.88};
    relax_void_fraction(eos, std::numeric_limits<double>::infinity(), 0., {rho, e, {}}, phi);
    EXPECT_NEAR(phi[0], 0.5, 1e-12);
    EXPECT_NEAR(pressure(eos, rho[1] / (1. - phi[1]), e[1]), 0., 1e-8);
    EXPECT_GT(phi[1], 0.4);
    EXPECT_EQ(phi[2], 0.);
    // Either closed under pressure, or balanced.
    const double p = pressure(eos, rho[3] / (1. - phi[3]), e[3]);
    EXPECT_TRUE((phi[3] == 0. && p > 0.) || std::abs(p) < 1e-8) << phi[3] << " " << p;
  }

  TEST(TillotsonLaw, ConstantsAreCheckedAndPublished)
  {
    Tillotson::Constants reversed         = aluminium;
    reversed.complete_vaporisation_energy = 0.02;
    EXPECT_THROW(Tillotson{reversed}, InputError);
    const auto &published = ModelRegistry<EquationOfState>::all().at("tillotson").description.published;
    EXPECT_EQ(published.size(), 6u);
    EXPECT_NEAR(published[0].constants.at("Tillotson bulk modulus"), 0.752, 1e-15);
    EXPECT_NEAR(published[0].constants.at("Tillotson complete vaporisation energy"), 0.139, 1e-15);
  }
} // namespace whipple
