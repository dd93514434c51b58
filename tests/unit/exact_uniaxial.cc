// SPDX-License-Identifier: LGPL-2.1-or-later
// Piston and plate impact of elastic-plastic solids against [ExactPack], against values of another program for the
// set-ups of [Maire2013] and [Wilkins1964], and against the jump conditions.
#include "exact_flow_check.h"

#include <whipple/error.h>
#include <whipple/exact/plate_impact.h>
#include <whipple/material/linear_hardening.h>
#include <whipple/material/mie_grueneisen.h>
#include <whipple/material/perfectly_plastic.h>

#include <gtest/gtest.h>

#include <cmath>

namespace
{
  using namespace whipple;
  using exact::LoadedState;
  using exact::PlateImpact;
  using exact::UniaxialLoading;
  using exact::WaveFront;

  Material
  solid(const MieGrueneisen::Constants &constants, double shear_modulus = 0, double yield_stress = 0)
  {
    Material material;
    material.name = "solid";
    material.eos  = std::make_shared<MieGrueneisen>(constants);
    if (shear_modulus > 0)
      material.strength = std::make_shared<PerfectlyPlastic>(shear_modulus, yield_stress);
    return material;
  }

  /// Mie-Grueneisen with a constant Gamma: P = K chi / (1 - s chi)^2 (1 - Gamma mu / 2) + Gamma gamma e. The form with
  /// which [ExactPack] computes; Whipple's own keeps Gamma gamma constant.
  class ConstantGamma : public EquationOfState
  {
  public:
    void
    evaluate(std::span<const double> true_density, std::span<const double> energy, std::span<double> pressure,
             std::span<double> sound_speed_squared) const override
    {
      const double rho0 = 2.79, k = rho0 * 0.533 * 0.533, s = 1.34, mu = true_density[0] / rho0 - 1.,
                   chi       = mu / (1. + mu);
      pressure[0]            = k * chi / std::pow(1. - s * chi, 2) * (1. - mu) + 2. * true_density[0] * energy[0];
      sound_speed_squared[0] = 0.533 * 0.533;
    }
    void
    derivatives(std::span<const double> true_density, std::span<const double>, std::span<double> dp_ddensity,
                std::span<double> dp_de) const override
    {
      dp_ddensity[0] = 0.533 * 0.533;
      dp_de[0]       = 2. * true_density[0];
    }
    double
    energy_of_pressure(double, double) const override
    {
      return 0.;
    }
    double
    reference_density() const override
    {
      return 2.79;
    }
    std::string
    name() const override
    {
      return "constant Gamma";
    }
  };

  const Material aluminium = solid({2.79, 0.533, 1.34, 2.}, 0.286, 0.0026);
  const Material wilkins   = solid({2.785, 0.5328, 1.338, 2.}, 0.276, 0.003);
  const Material fluid     = solid({2.785, 0.5328, 1.338, 2.});

  void
  expect_jump(const Material &material, const LoadedState &a, const WaveFront &front)
  {
    const LoadedState &b    = front.behind;
    const double       flux = a.density * (front.speed - a.velocity);
    EXPECT_NEAR(b.density * (front.speed - b.velocity), flux, 1e-9 * flux);
    EXPECT_NEAR(b.stress() - a.stress(), flux * (b.velocity - a.velocity), 1e-9 * b.stress());
    // total energy: what the stress does is what the material gains
    const double gain = b.energy - a.energy + 0.5 * (b.velocity * b.velocity - a.velocity * a.velocity);
    EXPECT_NEAR(b.stress() * b.velocity - a.stress() * a.velocity, flux * gain, 1e-9 * b.stress() * b.velocity);
    EXPECT_NEAR(b.pressure, exact::fluid_point(*material.eos, b.density, b.energy).pressure, 1e-12);
  }

  TEST(ExactPiston, HypoelasticOfExactPack)
  {
    Material material = aluminium;
    material.eos      = std::make_shared<ConstantGamma>();
    const UniaxialLoading        loading(material, 2.79, 0.);
    const std::vector<WaveFront> fronts = loading.fronts(0.01);
    ASSERT_EQ(fronts.size(), 2u);
    const LoadedState &y = fronts[0].behind, &b = fronts[1].behind;
    EXPECT_NEAR(y.density, 2.802710684, 1e-9);
    EXPECT_NEAR(y.pressure, 0.003646612969, 1e-11);
    EXPECT_NEAR(y.velocity, 0.002957210223, 1e-11);
    EXPECT_NEAR(y.deviator, 2. / 3. * 0.0026, 1e-15);
    EXPECT_NEAR(fronts[0].speed, 0.6520659744, 1e-9);
    EXPECT_NEAR(fronts[1].speed, 0.5505528459, 1e-9);
    EXPECT_NEAR(b.pressure, 0.01445554964, 1e-10);
    EXPECT_NEAR(b.density, 2.839226822, 1e-8);
    expect_jump(material, loading.initial(), fronts[0]);
    expect_jump(material, y, fronts[1]);
    EXPECT_NEAR(loading.stress(0.01), b.pressure + 2. / 3. * 0.0026, 1e-15);
  }

  TEST(ExactPiston, Copper)
  {
    const UniaxialLoading        loading(solid({8.93, 0.394, 1.49, 2.}, 0.45, 9e-4), 8.93, 0.);
    const std::vector<WaveFront> fronts = loading.fronts(0.002);
    ASSERT_EQ(fronts.size(), 2u);
    const double GPa = 0.01, km_s = 0.1;
    EXPECT_NEAR(fronts[0].behind.density, 8.9389345, 1e-7);
    EXPECT_NEAR(fronts[0].behind.pressure, 0.1390301 * GPa, 1e-9 * GPa * 100);
    EXPECT_NEAR(fronts[0].behind.stress(), 0.1990301 * GPa, 1e-9 * GPa * 100);
    EXPECT_NEAR(fronts[0].behind.velocity, 4.719816e-3 * km_s, 1e-9 * km_s);
    EXPECT_NEAR(fronts[0].speed, 4.7221765 * km_s, 1e-7 * km_s);
    EXPECT_NEAR(fronts[1].speed, 3.9769475 * km_s, 1e-7 * km_s);
    EXPECT_NEAR(fronts[1].behind.pressure, 0.681591 * GPa, 1e-6 * GPa);
    EXPECT_NEAR(fronts[1].behind.stress(), 0.741591 * GPa, 1e-6 * GPa);
    EXPECT_NEAR(fronts[1].behind.density, 8.9734531, 1e-7);
  }

  TEST(ExactPiston, OneFrontIfSlowOrStrong)
  {
    const UniaxialLoading        loading(aluminium, 2.79, 0.);
    const std::vector<WaveFront> slow = loading.fronts(0.002), strong = loading.fronts(0.3);
    ASSERT_EQ(slow.size(), 1u);
    expect_jump(aluminium, loading.initial(), slow[0]);
    EXPECT_NEAR(slow[0].behind.deviator, 4. / 3. * 0.286 * std::log(slow[0].behind.density / 2.79), 1e-15);
    ASSERT_EQ(strong.size(), 1u);
    expect_jump(aluminium, loading.initial(), strong[0]);
    EXPECT_NEAR(strong[0].behind.deviator, 2. / 3. * 0.0026, 1e-15);
    EXPECT_THROW(loading.fronts(-0.01), InputError);
  }

  TEST(ExactPiston, HardeningFollowsTheYieldSurface)
  {
    Material hard = aluminium;
    hard.strength = std::make_shared<LinearHardening>(LinearHardening::Constants{0.286, 0.0026, 0.0667});
    const UniaxialLoading        loading(hard, 2.79, 0.);
    const std::vector<WaveFront> fronts = loading.fronts(0.01);
    ASSERT_EQ(fronts.size(), 2u);
    expect_jump(hard, fronts[0].behind, fronts[1]);
    // plastic strain 2 G ln(rho / rho_y) / (3 G + H) beyond the yield point
    const double plastic =
        2. * 0.286 * std::log(fronts[1].behind.density / fronts[0].behind.density) / (3. * 0.286 + 0.0667);
    EXPECT_NEAR(fronts[1].behind.deviator, 2. / 3. * (0.0026 + 0.0667 * plastic), 1e-12);
  }

  TEST(ExactPiston, StatesInSpaceAndTime)
  {
    for (const double side : {1., -1.})
      {
        const exact::Piston piston(UniaxialLoading(aluminium, 2.79, 0.), {0., side, side * 1., 0.01, 0.});
        EXPECT_NEAR(piston.at(side * 0.6, 1.).velocity, side * 0.00295721, 2e-8);
        EXPECT_NEAR(piston.at(side * 0.3, 1.).density, 2.8392268, 2e-6);
        EXPECT_EQ(piston.at(side * 0.7, 1.).density, 2.79);
        EXPECT_NEAR(*piston.shock_position(2.), side * 2. * 0.5505528, 1e-4);
        EXPECT_TRUE(piston.counts(side * 0.99, 1.5));
        // the elastic front is at the far end at 1.5336 us, and at 1.7 us its echo not yet half-way back
        EXPECT_FALSE(piston.counts(side * 0.95, 1.7));
        EXPECT_TRUE(piston.counts(side * 0.5, 1.7));
      }
  }

  PlateImpact::Plate
  plate(const Material &material, double density, double lower, double upper, double velocity)
  {
    return {UniaxialLoading(material, density, 0.), material.eos, lower, upper, velocity};
  }

  TEST(ExactPlateImpact, Wilkins)
  {
    const PlateImpact impact(plate(wilkins, 2.785, -0.5, 0., 0.08), plate(wilkins, 2.785, 0., 4.5, 0.));
    EXPECT_NEAR(impact.interface_velocity(), 0.04, 1e-15);
    const auto elastic = impact.at(0.62, 1.), plastic = impact.at(0.5, 1.);
    EXPECT_NEAR(elastic.density, 2.8001771, 1e-7);
    EXPECT_NEAR(elastic.pressure, 4.358785e-3, 1e-9);
    EXPECT_NEAR(elastic.velocity, 3.517837e-3, 1e-9);
    EXPECT_NEAR(plastic.pressure, 6.435879e-2, 1e-8);
    const std::vector<double> breaks = impact.breaks(0.7);
    ASSERT_EQ(breaks.size(), 5u);
    EXPECT_NEAR(breaks[4], 0.7 * 0.6490426, 1e-7);
    EXPECT_NEAR(breaks[3], 0.7 * 0.5908519, 1e-7);
    EXPECT_NEAR(breaks[2], 0.7 * 0.04, 1e-12);
    EXPECT_NEAR(breaks[0], 0.7 * (0.08 - 0.6490426), 1e-7);
  }

  TEST(ExactPlateImpact, SymmetricAluminium400)
  {
    const Material        material = solid({2.7, 0.5328, 1.338, 2.}, 0.276, 0.003);
    const PlateImpact     impact(plate(material, 2.7, -1., 0., 0.04), plate(material, 2.7, 0., 1., 0.));
    const UniaxialLoading loading(material, 2.7, 0.);
    const auto            fronts = loading.fronts(0.02);
    EXPECT_NEAR(fronts[0].behind.stress(), 6.226085e-3, 1e-9);
    EXPECT_NEAR(fronts[0].behind.velocity, 3.535305e-3, 1e-9);
    EXPECT_NEAR(fronts[0].speed, 0.6522654, 1e-7);
    EXPECT_NEAR(fronts[1].behind.stress(), 3.129341e-2, 1e-8);
    EXPECT_NEAR(fronts[1].speed, 0.5643640, 1e-7);
    EXPECT_NEAR(fronts[1].behind.density, 2.796822, 1e-6);
    EXPECT_NEAR(impact.at(0.2, 1.).pressure, fronts[1].behind.pressure, 1e-12);
  }

  TEST(ExactPlateImpact, HugoniotAndReleaseWithoutStrength)
  {
    const double      u = 0.329, us = 0.5328 + 1.338 * u;
    const PlateImpact impact(plate(fluid, 2.785, -2., 0., 2. * u), plate(fluid, 2.785, 0., 1., 0.));
    EXPECT_NEAR(impact.at(0.4, 0.8).pressure, 2.785 * us * u, 1e-9);
    EXPECT_NEAR(*impact.shock_position(0.8), 0.8 * us, 1e-9);
    exact_check::expect_shock(impact, 0.8 * us, 0.8);
    // released face: along the exact isentrope, by another program
    const auto released = impact.at(1.25, 1.4);
    EXPECT_NEAR(released.velocity / (2. * u), 1.029, 5e-4);
    EXPECT_EQ(released.pressure < 1e-9, true);
    EXPECT_EQ(impact.at(1.3, 1.4).density, 0.);
    EXPECT_TRUE(impact.counts(1.25, 1.4));
    EXPECT_FALSE(impact.shock_position(1.4).has_value());
    // the fan obeys the equations of motion
    const exact_check::Flow flow{1, [](double rho, double e) { return exact::fluid_point(*fluid.eos, rho, e); }};
    exact_check::expect_euler(flow, impact, {0.7, 1.2}, 1.4, 1e-4);
  }

  TEST(ExactPlateImpact, UnlikePlates)
  {
    const Material    tantalum = solid({16.654, 0.3414, 1.201, 2.}, 0.69, 0.0077);
    const PlateImpact impact(plate(aluminium, 2.79, -1.025, -0.025, 0.18), plate(tantalum, 16.654, 0.025, 1.025, 0.));
    const double      u = impact.interface_velocity(), contact = 0.05 / 0.18, now = contact + 0.5;
    EXPECT_NEAR(UniaxialLoading(aluminium, 2.79, 0.).stress(0.18 - u), UniaxialLoading(tantalum, 16.654, 0.).stress(u),
                1e-12);
    EXPECT_EQ(impact.at(0.01, 0.5 * contact).density, 0.);
    EXPECT_EQ(impact.at(-0.5, 0.5 * contact).velocity, 0.18);
    const double face = 0.025 + 0.5 * u;
    EXPECT_NEAR(impact.at(face - 1e-3, now).velocity, u, 1e-12);
    EXPECT_NEAR(impact.at(face + 1e-3, now).velocity, u, 1e-12);
    EXPECT_GT(impact.at(face + 1e-3, now).density, 16.654);
    EXPECT_LT(impact.at(face - 1e-3, now).density, 4.);
    // a plate with strength is unknown behind the release of its far face
    EXPECT_TRUE(impact.counts(0.5, contact + 2.));
    EXPECT_FALSE(impact.counts(1.0, contact + 2.7));
    EXPECT_FALSE(impact.counts(0.3, contact + 20.));
    EXPECT_THROW(PlateImpact(plate(fluid, 2.785, -1., 0., 0.), plate(fluid, 2.785, 0., 1., 0.1)), InputError);
  }

  TEST(ExactPlateImpact, NeedsTwoBodiesThatMeet)
  {
    exact::ExactRequest<2> request;
    request.name = "plate impact";
    EXPECT_THROW(exact::make_plate_impact(request), InputError);
    for (const double side : {0., 1.})
      {
        exact::BodyState<2> body;
        body.material = aluminium;
        body.density  = 2.79;
        body.lower    = {{0., side}};
        body.upper    = {{1., side + 1.}};
        body.velocity = {{0., 0.02 * side}};
        request.bodies.push_back(body);
      }
    EXPECT_THROW(exact::make_plate_impact(request), InputError);
    request.bodies[0].velocity[1] = 0.04;
    const auto solution           = exact::make_plate_impact(request);
    EXPECT_NEAR(solution->at({{0.5, 1.05}}, 0.3).velocity[1], 0.03, 1e-12);
  }
} // namespace
