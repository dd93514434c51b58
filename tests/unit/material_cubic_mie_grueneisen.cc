// SPDX-License-Identifier: LGPL-2.1-or-later
// Mie-Grueneisen about a cubic Hugoniot: the Hugoniot it was made of, the linear law as a special case, contract of an
// equation of state, the end of the fit.
#include "equation_of_state_check.h"

#include <whipple/material/cubic_mie_grueneisen.h>
#include <whipple/material/mie_grueneisen.h>
#include <whipple/material/model_registry.h>

namespace whipple
{
  namespace
  {
    using namespace eos_check;
    using Constants = CubicMieGrueneisen::Constants;

    const Constants lead{11.34, 0.2006, {1.429, 0.8506, -1.64}, 2.74, 0.54};

    std::vector<std::pair<std::string, Constants>>
    published()
    {
      std::vector<std::pair<std::string, Constants>> result;
      for (const auto &row : ModelRegistry<EquationOfState>::all().at("cubic mie-grueneisen").description.published)
        {
          const auto &c = row.constants;
          result.push_back({row.material,
                            {c.at("Density"),
                             c.at("Sound speed"),
                             {c.at("Hugoniot slope"), c.at("Hugoniot quadratic slope"), c.at("Hugoniot cubic slope")},
                             c.at("Grueneisen coefficient"),
                             c.at("Grueneisen slope")}});
        }
      return result;
    }

    /// Shock speed for a particle speed: the cubic relation itself, by fixed-point iteration from c0.
    double
    shock_speed(const Constants &k, double u)
    {
      double speed = k.sound_speed + u;
      for (int i = 0; i < 10000; ++i)
        {
          const double x    = u / speed;
          const double next = k.sound_speed + u * (k.hugoniot.s1 + k.hugoniot.s2 * x + k.hugoniot.s3 * x * x);
          speed             = 0.5 * (speed + next);
        }
      return speed;
    }

    /// Shocked along the Hugoniot, released, expanded and hot, cold tension, nearly void.
    std::vector<State>
    states(const Constants &k)
    {
      std::vector<State> result;
      const double       heat = k.sound_speed * k.sound_speed;
      for (const double ratio : {1.6, 1.4, 1.2, 1.02, 0.97, 0.9, 0.6, 0.2})
        for (const double e : {-0.02 * heat, 0., 0.1 * heat, 0.5 * heat, 3. * heat})
          result.push_back({ratio * k.reference_density, e});
      return result;
    }
  } // namespace

  TEST(CubicMieGrueneisenLaw, ShocksObeyTheCubicRelation)
  {
    for (const auto &[material, k] : published())
      for (const double share : {0.05, 0.3, 0.8, 1.2})
        {
          const double u            = share * k.sound_speed;
          const double speed        = shock_speed(k, u);
          const double true_density = k.reference_density / (1. - u / speed);
          SCOPED_TRACE(material + " u " + std::to_string(u));
          const CubicMieGrueneisen eos(k);
          const double             p = k.reference_density * speed * u;
          EXPECT_NEAR(pressure(eos, true_density, 0.5 * u * u), p, 1e-12 * p);
          EXPECT_GT(sound_speed_squared(eos, true_density, 0.5 * u * u), 0.);
          // Sound behind a shock catches up with it.
          EXPECT_GT(std::sqrt(sound_speed_squared(eos, true_density, 0.5 * u * u)), speed - u);
          expect_exact_derivatives(eos, {true_density, 0.5 * u * u}, 0.1 * k.sound_speed * k.sound_speed, 1e-8);
        }
  }

  TEST(CubicMieGrueneisenLaw, WithoutCurvatureIsTheLinearLaw)
  {
    const MieGrueneisen      linear({2.785, 0.5328, 1.338, 2.0});
    const CubicMieGrueneisen cubic({2.785, 0.5328, {1.338, 0., 0.}, 2.0, 0.});
    EXPECT_NEAR(cubic.max_density(), linear.max_density(), 1e-12 * linear.max_density());
    for (const State &state : states({2.785, 0.5328, {1.338, 0., 0.}, 2.0, 0.}))
      {
        const double p  = pressure(linear, state.true_density, state.e),
                     c2 = sound_speed_squared(linear, state.true_density, state.e);
        EXPECT_NEAR(pressure(cubic, state.true_density, state.e), p, 1e-14 * (1. + std::abs(p)));
        EXPECT_NEAR(sound_speed_squared(cubic, state.true_density, state.e), c2, 1e-14 * (1. + std::abs(c2)));
      }
  }

  TEST(CubicMieGrueneisenLaw, ContractOfAnEquationOfState)
  {
    for (const auto &[material, k] : published())
      {
        SCOPED_TRACE(material);
        const CubicMieGrueneisen eos(k);
        const double             heat = k.sound_speed * k.sound_speed;
        for (const State &state : states(k))
          {
            expect_exact_derivatives(eos, state, 0.1 * heat, 2e-8);
            expect_inverse(eos, state, heat, 1e-13);
          }
        expect_batch_is_scalar(eos, states(k));
        expect_isentropic(eos, {1.4 * k.reference_density, 0.5 * heat}, k.reference_density, 400, 1e-9);
        expect_isentropic(eos, {k.reference_density, 0.2 * heat}, 0.7 * k.reference_density, 400, 1e-9);
        EXPECT_EQ(pressure(eos, k.reference_density, 0.), 0.);
        EXPECT_NEAR(sound_speed_squared(eos, k.reference_density, 0.), heat, 1e-13);
        for (const double e : {-0.1 * heat, 0., heat})
          {
            const double above = k.reference_density * (1. + 1e-12), below = k.reference_density * (1. - 1e-12);
            EXPECT_NEAR(pressure(eos, above, e), pressure(eos, below, e), 1e-11);
            EXPECT_NEAR(sound_speed_squared(eos, above, e), sound_speed_squared(eos, below, e), 1e-10);
          }
        EXPECT_LT(pressure(eos, 1e-3 * k.reference_density, 5. * heat), 0.);
      }
  }

  TEST(CubicMieGrueneisenLaw, EndsWhereTheFitDoes)
  {
    // Lexan has a pole, D(chi) = 0; lead has none, but its Hugoniot pressure has a maximum; nylon has neither.
    for (const auto &[material, k] : published())
      {
        SCOPED_TRACE(material);
        const CubicMieGrueneisen eos(k);
        const double             limit  = eos.max_density();
        const auto               chi_of = [&](double true_density) { return 1. - k.reference_density / true_density; };
        const auto               D      = [&](double chi) {
          return 1. - chi * (k.hugoniot.s1 + chi * (k.hugoniot.s2 + chi * k.hugoniot.s3));
        };
        const auto hugoniot = [&](double chi) { return chi / (D(chi) * D(chi)); };
        EXPECT_EQ(std::isinf(limit), material == "nylon 6/6");
        EXPECT_THROW(eos.check_density(1.0001 * limit), StateError);
        if (material == "lexan")
          {
            EXPECT_NEAR(D(chi_of(limit)), 0., 1e-12);
          }
        if (material == "lead")
          {
            EXPECT_NEAR(slope(hugoniot, chi_of(limit), 1e-4), 0., 1e-6);
            EXPECT_GT(limit, 4. * k.reference_density);
          }
        double last = 0.;
        for (double chi = 0.01; chi < (std::isinf(limit) ? 1. : chi_of(limit)); chi += 0.01)
          {
            EXPECT_GT(hugoniot(chi), last) << chi;
            last = hugoniot(chi);
          }
      }
  }

  TEST(CubicMieGrueneisenLaw, ConstantsAreChecked)
  {
    Constants impossible        = lead;
    impossible.grueneisen_slope = 3.;
    EXPECT_THROW(CubicMieGrueneisen{impossible}, InputError);
    impossible             = lead;
    impossible.sound_speed = -0.2;
    EXPECT_THROW(CubicMieGrueneisen{impossible}, InputError);
    EXPECT_THROW(CubicMieGrueneisen(lead).energy_of_pressure(60., 1.), StateError);
  }
} // namespace whipple
