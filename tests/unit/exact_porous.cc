// SPDX-License-Identifier: LGPL-2.1-or-later
// Piston into porous material that crushes by the P-alpha law: against roots of the jump conditions found elsewhere,
// against the closed form of the compacted Hugoniot, and against the conditions themselves.
#include "../figure.h"

#include <whipple/error.h>
#include <whipple/exact/compaction_loading.h>
#include <whipple/exact/fluid_point.h>
#include <whipple/exact/piston.h>
#include <whipple/exact/porous_piston.h>
#include <whipple/material/mie_grueneisen.h>

#include <gtest/gtest.h>

#include <cmath>

namespace
{
  using namespace whipple;
  using exact::CompactionLoading;
  using exact::LoadedState;
  using exact::WaveFront;

  constexpr MieGrueneisen::Constants aluminium{2.785, 0.5328, 1.338, 2.};
  constexpr PAlphaVoidLaw::Constants law{0.3, 0.002, 0.02};
  const double                       bulk = 0.7 * 2.785;

  CompactionLoading
  loading(const PAlphaVoidLaw::Constants &constants = law, double density = bulk)
  {
    return CompactionLoading(std::make_shared<MieGrueneisen>(aluminium), constants, density, 0.);
  }

  void
  expect_jump(const LoadedState &a, const WaveFront &front, double alpha)
  {
    const LoadedState &b    = front.behind;
    const double       flux = a.density * (front.speed - a.velocity);
    EXPECT_NEAR(b.density * (front.speed - b.velocity), flux, 1e-12 * flux);
    EXPECT_NEAR(b.pressure - a.pressure, flux * (b.velocity - a.velocity), 1e-12 * b.pressure);
    const double gain = b.energy - a.energy + 0.5 * (b.velocity * b.velocity - a.velocity * a.velocity);
    EXPECT_NEAR(b.pressure * b.velocity - a.pressure * a.velocity, flux * gain, 1e-12 * b.pressure * b.velocity);
    EXPECT_NEAR(b.pressure, exact::fluid_point(MieGrueneisen(aluminium), alpha * b.density, b.energy).pressure / alpha,
                1e-12 * b.pressure);
  }

  TEST(ExactPorousPiston, PrecursorAndCompactionShock)
  {
    // roots of the jump conditions with the quadratic curve [Herrmann1969], by the hybrid method of MINPACK
    struct Row
    {
      double velocity, density, energy, speed, pressure;
    };
    const Row rows[] = {{0.03, 2.457673358, 0.0006046380646, 0.1396351852, 0.009567089014},
                        {0.05, 2.787676294, 0.001462646962, 0.1631845398, 0.01717146658},
                        {0.1, 2.893061101, 0.005142967391, 0.3049003982, 0.06014299031}};
    for (const Row &row : rows)
      {
        SCOPED_TRACE(row.velocity);
        const std::vector<WaveFront> fronts = loading().fronts(row.velocity);
        ASSERT_EQ(fronts.size(), 2u);
        const LoadedState &yield = fronts[0].behind, &b = fronts[1].behind;
        EXPECT_NEAR(yield.density, 1.956503079, 1e-9);
        EXPECT_NEAR(yield.energy, 1.836053067e-6, 1e-15);
        EXPECT_NEAR(fronts[0].speed, 0.5353639746, 1e-10);
        EXPECT_NEAR(yield.velocity, 0.001916274024, 1e-12);
        EXPECT_NEAR(yield.pressure, 0.002, 1e-15);
        EXPECT_NEAR(b.density / row.density, 1., 1e-9);
        EXPECT_NEAR(b.energy / row.energy, 1., 1e-9);
        EXPECT_NEAR(fronts[1].speed / row.speed, 1., 1e-9);
        EXPECT_NEAR(b.pressure / row.pressure, 1., 1e-9);
        expect_jump(loading().initial(), fronts[0], 1. / 0.7);
        const double share = std::max(0., (0.02 - b.pressure) / 0.018);
        expect_jump(yield, fronts[1], 1. + (1. / 0.7 - 1.) * share * share);
      }
  }

  TEST(ExactPorousPiston, OneFrontIfSlowOrFast)
  {
    const std::vector<WaveFront> slow = loading().fronts(0.0015), fast = loading().fronts(0.2);
    ASSERT_EQ(slow.size(), 1u);
    EXPECT_LT(slow[0].behind.pressure, 0.002);
    expect_jump(loading().initial(), slow[0], 1. / 0.7);
    // taken from the precursor the compaction shock would run at 0.5376 cm/us, the precursor runs at 0.5354
    ASSERT_EQ(fast.size(), 1u);
    EXPECT_NEAR(fast[0].speed, 0.5375513225, 1e-9);
    EXPECT_NEAR(fast[0].behind.pressure, 0.2095912606, 1e-9);
    expect_jump(loading().initial(), fast[0], 1.);
    EXPECT_THROW(loading().fronts(0.), InputError);
    EXPECT_THROW(loading(law, 1.05 * bulk), InputError);
  }

  TEST(ExactPorousPiston, CompactedHugoniotInClosedForm)
  {
    // Without an elastic range and fully compacted, e = P (1/rho00 - 1/gamma) / 2 in Mie-Grueneisen gives
    // P = P_H [1 - G g0 (1/g0 - 1/gamma)/2] / [1 - G g0 (1/rho00 - 1/gamma)/2], P_H of the solid at the same gamma.
    for (const double u : {0.1, 0.3, 0.6})
      {
        const WaveFront front        = loading({0.3, 0., 0.02}).fronts(u).back();
        const double    true_density = front.behind.density, chi = 1. - 2.785 / true_density;
        const double    solid    = 2.785 * 0.5328 * 0.5328 * chi / std::pow(1. - 1.338 * chi, 2);
        const double    expected = solid * (1. - chi) / (1. - 2.785 * (1. / bulk - 1. / true_density)); // G = 2
        figure::expect_relative("pressure of compacted aluminium, 30 % porous, piston at " + std::to_string(u) +
                                    " cm/us",
                                front.behind.pressure, expected, 1e-11);
        EXPECT_NEAR(front.behind.pressure, bulk * front.speed * u, 1e-12 * front.behind.pressure);
      }
  }

  TEST(ExactPorousPiston, StatesInSpaceAndTime)
  {
    const exact::Piston piston(loading(), {0., 1., 10., 0.05, 0.});
    EXPECT_NEAR(piston.at(1., 10.).density, 2.787676294, 1e-9);
    EXPECT_NEAR(piston.at(2., 10.).pressure, 0.002, 1e-14);
    EXPECT_EQ(piston.at(6., 10.).density, bulk);
    EXPECT_NEAR(*piston.shock_position(10.), 1.631845398, 1e-8);
    EXPECT_TRUE(piston.counts(9., 18.));
    EXPECT_FALSE(piston.counts(9.9, 19.));
  }

  exact::ExactRequest<2>
  scene()
  {
    exact::ExactRequest<2> request;
    request.name                   = "p-alpha piston";
    request.upper                  = {{1., 10.}};
    request.boundaries[2].kind     = BoundaryKind::inflow;
    request.boundaries[2].velocity = {{0., 0.05}};
    exact::BodyState<2> body;
    body.name              = "foam";
    body.material.eos      = std::make_shared<MieGrueneisen>(aluminium);
    body.material.void_law = std::make_shared<PAlphaVoidLaw>(law);
    body.upper             = {{1., 10.}};
    body.density           = bulk;
    request.bodies.push_back(body);
    return request;
  }

  TEST(ExactPorousPiston, FromAScene)
  {
    exact::ExactRequest<2> request  = scene();
    const auto             solution = exact::make_porous_piston(request);
    EXPECT_NEAR(solution->at({{0.5, 1.}}, 10.).velocity[1], 0.05, 1e-12);
    EXPECT_NEAR(solution->at({{0.5, 1.}}, 10.).density, 2.787676294, 1e-9);
    request.bodies[0].material.void_law.reset();
    EXPECT_THROW(exact::make_porous_piston(request), InputError);
    request                    = scene();
    request.boundaries[2].kind = BoundaryKind::reflecting;
    EXPECT_THROW(exact::make_porous_piston(request), InputError);
    request                 = scene();
    request.bodies[0].lower = {{0., 1.}};
    EXPECT_THROW(exact::make_porous_piston(request), InputError);
  }
} // namespace
