// SPDX-License-Identifier: LGPL-2.1-or-later
// Linear elastic solutions: Blake's cavity [Blake1952] against another program and the equations of motion, spall
// against the acoustic solution.
#include "exact_flow_check.h"

#include <whipple/error.h>
#include <whipple/exact/blake.h>
#include <whipple/exact/spall.h>
#include <whipple/material/mie_grueneisen.h>
#include <whipple/material/perfectly_plastic.h>

#include <gtest/gtest.h>

#include <cmath>

namespace
{
  using namespace whipple;
  using exact::Blake;
  using exact::Spall;
  using exact_check::derivative;

  // rho 3000 kg/m^3, a 0.1 m, lambda = G = 25 GPa, P 1 MPa in cm, g, us, Mbar
  const Blake::Constants granite{3., 0.25 * 5. / 3., 0.25, 10., 1e-5};

  TEST(ExactBlake, TableOfTheReference)
  {
    const Blake blake(granite);
    EXPECT_NEAR(blake.wave_speed(), 0.5, 1e-15);
    struct Row
    {
      double r, u, radial, pressure, difference; // m, m, Pa
    };
    const Row rows[] = {
        {.10, 1.0017698e-6, -1.0e6, -983.24, 1501474.9},     {.15, 4.4533425e-7, -297806.34, 509.36, 445945.48},
        {.20, 2.4931792e-7, -128092.53, 1907.54, 189277.49}, {.30, 1.0524476e-7, -42558.473, 4153.83, 57606.97},
        {.50, 3.1830905e-8, -920.72204, -3025.25, 5918.97},  {.70, 6.9094253e-8, 27108.328, -20543.85, 9846.71},
        {.85, 5.5960518e-8, -54617.086, 26685.28, 41897.72}};
    for (const Row &row : rows)
      {
        SCOPED_TRACE(row.r);
        const Blake::Elastic state = blake.elastic(100. * row.r, 160.);
        EXPECT_NEAR(state.displacement / 100., row.u, 1e-7 * row.u);
        EXPECT_NEAR(state.radial * 1e11, row.radial, 1e-7 * std::abs(row.radial));
        EXPECT_NEAR(blake.at(100. * row.r, 160.).pressure * 1e11, row.pressure, 0.006);
        EXPECT_NEAR(std::abs(state.radial - state.hoop) * 1e11, row.difference, 0.05);
      }
    EXPECT_EQ(blake.elastic(90.1, 160.).displacement, 0.);
    EXPECT_NEAR(blake.breaks(160.)[0], 90., 1e-12);
  }

  TEST(ExactBlake, ObeysTheEquationsOfMotion)
  {
    const Blake blake(granite);
    for (const double r : {12., 25., 40., 70.})
      {
        const double t = 160.;
        // rho dv/dt = d sigma_rr / dr + 2 (sigma_rr - sigma_tt) / r, v = du/dt
        const double force = derivative([&](double d) { return blake.elastic(r + d, t).radial; }, 1e-2) +
                             2. * (blake.elastic(r, t).radial - blake.elastic(r, t).hoop) / r;
        const double inertia = 3. * derivative([&](double d) { return blake.elastic(r, t + d).velocity; }, 1e-2);
        EXPECT_NEAR(inertia, force, 1e-7 * std::abs(force));
        const double velocity = derivative([&](double d) { return blake.elastic(r, t + d).displacement; }, 1e-2);
        EXPECT_NEAR(blake.elastic(r, t).velocity, velocity, 1e-6 * std::abs(velocity));
      }
    for (const double t : {0.1, 10., 50., 300.})
      EXPECT_NEAR(blake.elastic(10., t).radial, -1e-5, 1e-16);
  }

  TEST(ExactBlake, CountsUntilTheRimAnswers)
  {
    Blake::Constants finite = granite;
    finite.rim              = 100.;
    const Blake blake(finite);
    EXPECT_TRUE(blake.counts(99., 175.));
    EXPECT_TRUE(blake.counts(50., 250.));
    EXPECT_FALSE(blake.counts(90., 210.));
  }

  Spall::Constants
  plates()
  {
    Spall::Constants constants;
    constants.density      = 2.785;
    constants.bulk_modulus = 2.785 * 0.5328 * 0.5328;
    constants.wave_speed   = 0.5328;
    constants.flyer        = 0.2;
    constants.target       = 0.5;
    constants.velocity     = 1e-3;
    return constants;
  }

  TEST(ExactSpall, PlaneTimeAndPullBack)
  {
    Spall::Constants constants = plates();
    const double     tension   = 0.5 * 2.785 * 0.5328 * 1e-3;
    EXPECT_FALSE(Spall(constants).spalls());
    constants.strength = 0.4 * tension;
    const Spall spall(constants);
    EXPECT_TRUE(spall.spalls());
    EXPECT_NEAR(spall.spall_plane(), 0.3, 1e-15);
    EXPECT_NEAR(spall.spall_time(), 0.7 / 0.5328, 1e-15);
    EXPECT_NEAR(spall.pull_back(), 0.4e-3, 1e-15);

    // the first tension anywhere in the plates, by search
    double first = 1e9, where = 0;
    for (int i = 0; i < 700; ++i)
      for (int j = 0; j < 2000; ++j)
        {
          const double x = -0.2 + (i + 0.5) * 1e-3, t = (j + 0.5) * 1e-3;
          if (t < first && spall.stress(x, t) < -1e-9)
            {
              first = t;
              where = x;
            }
        }
    EXPECT_NEAR(first, spall.spall_time(), 2.5e-3);
    EXPECT_NEAR(where, spall.spall_plane(), 2e-3);
    EXPECT_NEAR(spall.stress(0.3, spall.spall_time() + 0.01), -tension, 1e-15);
    EXPECT_TRUE(spall.counts(0.3, 1.31));
    EXPECT_FALSE(spall.counts(0.3, 1.32));
    EXPECT_TRUE(spall.counts(0.45, 1.5));
  }

  TEST(ExactSpall, StatesOfTheAcousticImpact)
  {
    const Spall  spall(plates());
    const double p = 0.5 * 2.785 * 0.5328 * 1e-3;
    EXPECT_NEAR(spall.at(0.1, 0.3).pressure, p, 1e-15);
    EXPECT_NEAR(spall.at(0.1, 0.3).velocity, 0.5e-3, 1e-15);
    EXPECT_NEAR(spall.at(0.1, 0.3).density, 2.785 * (1. + 0.5e-3 / 0.5328), 1e-12);
    EXPECT_EQ(spall.at(0.3, 0.3).velocity, 0.);
    EXPECT_EQ(spall.at(-0.19, 0.3).velocity, 1e-3);
    // free faces bear nothing, whatever arrives
    for (const double t : {0.1, 0.5, 0.95, 1.2, 1.5, 2.7})
      {
        EXPECT_EQ(spall.stress(0.5, t), 0.);
        EXPECT_EQ(spall.stress(-0.2, t), 0.);
      }
    EXPECT_NEAR(spall.at(0.5, 1.).velocity, 1e-3, 1e-15);
    // the free face flies at V from H / c on; the flyer's stops when its release has come
    const double travelled = 1e-3 * (1.2 - 0.5 / 0.5328), stopped = 1e-3 * 0.2 / 0.5328;
    EXPECT_GT(spall.at(0.5 + travelled - 1e-9, 1.2).density, 0.);
    EXPECT_EQ(spall.at(0.5 + travelled + 1e-9, 1.2).density, 0.);
    EXPECT_GT(spall.at(-0.2 + stopped + 1e-9, 1.2).density, 0.);
    EXPECT_EQ(spall.at(-0.2 + stopped - 1e-9, 1.2).density, 0.);
    const std::vector<double> breaks = spall.breaks(0.3);
    ASSERT_EQ(breaks.size(), 2u);
    EXPECT_NEAR(breaks[0], -0.3 * 0.5328, 1e-12);
    EXPECT_NEAR(breaks[1], 0.3 * 0.5328, 1e-12);
    // every break is a jump, and there is none elsewhere
    for (const double t : {0.3, 0.5, 0.95, 1.2, 1.5, 2.7})
      {
        const std::vector<double> jumps = spall.breaks(t);
        int                       found = 0;
        for (int i = 0; i < 6999; ++i)
          {
            const double x    = -0.2 + 1e-4 * (i + 0.5);
            const auto   here = spall.at(x, t), next = spall.at(x + 1e-4, t);
            found += here.density > 0 && next.density > 0 && here.velocity != next.velocity;
          }
        EXPECT_EQ(found, static_cast<int>(jumps.size())) << t;
      }
  }

  exact::BodyState<2>
  body(double lower, double upper, double velocity)
  {
    exact::BodyState<2> state;
    state.material.name     = "aluminium";
    state.material.eos      = std::make_shared<MieGrueneisen>(MieGrueneisen::Constants{2.785, 0.5328, 1.338, 2.});
    state.material.strength = std::make_shared<PerfectlyPlastic>(0.286, 0.01);
    state.density           = 2.785;
    state.lower             = {{0., lower}};
    state.upper             = {{1., upper}};
    state.velocity          = {{0., velocity}};
    return state;
  }

  TEST(ExactSpall, FromAScene)
  {
    exact::ExactRequest<2> request;
    request.name          = "spall";
    request.bodies        = {body(0., 0.5, 0.), body(-0.2, 0., 1e-3)};
    const auto   solution = exact::make_spall(request);
    const double c        = std::sqrt(0.5328 * 0.5328 + 4. / 3. * 0.286 / 2.785);
    EXPECT_NEAR(solution->at({{0.5, 0.1}}, 0.2).pressure, 0.5e-3 * 2.785 * 0.5328 * 0.5328 / c, 1e-12);
    EXPECT_EQ(solution->at({{0.5, 0.2}}, 0.2).pressure, 0.);
    request.bodies.back().upper[1] = -0.01;
    EXPECT_THROW(exact::make_spall(request), InputError);
    request.bodies.pop_back();
    EXPECT_THROW(exact::make_spall(request), InputError);

    request.name      = "blake";
    request.symmetry  = Symmetry::axisymmetric;
    request.upper     = {{100., 100.}};
    request.constants = {{"Cavity radius", 10.}, {"Cavity pressure", 1e-5}};
    const auto cavity = exact::make_blake(request);
    EXPECT_NEAR(cavity->at({{0., 10.}}, 1.).pressure, cavity->at({{6., 8.}}, 1.).pressure, 1e-18);
    request.bodies[0].material.strength = nullptr;
    EXPECT_THROW(exact::make_blake(request), InputError);
  }
} // namespace
