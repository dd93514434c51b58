// SPDX-License-Identifier: LGPL-2.1-or-later
// Smooth flows of two dimensions against the equations of motion, and the bodies that only move.
#include <whipple/error.h>
#include <whipple/exact/entropy_wave.h>
#include <whipple/exact/fluid_point.h>
#include <whipple/exact/isentropic_vortex.h>
#include <whipple/exact/rotation.h>
#include <whipple/exact/sound_wave.h>
#include <whipple/exact/translation.h>
#include <whipple/exact/void_rate.h>
#include <whipple/material/ideal_gas.h>
#include <whipple/material/linear_polynomial.h>
#include <whipple/material/mie_grueneisen.h>
#include <whipple/material/rate_void_law.h>

#include <gtest/gtest.h>

#include <cmath>

namespace
{
  using namespace whipple;
  using exact::PointState;

  template <class F>
  double
  slope(const F &f, double h)
  {
    return (8. * (f(h) - f(-h)) - (f(2. * h) - f(-2. * h))) / (12. * h);
  }

  /// Residuals of the equations of motion at a point, each over the largest term `scale` of its kind.
  struct Residual
  {
    double mass = 0, momentum[2] = {0, 0}, energy = 0, law = 0;
  };

  Residual
  residual(const exact::ExactSolution<2> &flow, const EquationOfState &eos, Symmetry symmetry, Vector<2> x, double t,
           double h)
  {
    const auto along = [&](int d, const auto &value) {
      return slope(
          [&](double s) {
            Vector<2> y = x;
            y[d] += s;
            return value(flow.at(y, t));
          },
          h);
    };
    const auto in_time = [&](const auto &value) {
      return slope([&](double s) { return value(flow.at(x, t + s)); }, h);
    };
    const auto          rho     = [](const PointState<2> &s) { return s.density; };
    const auto          p       = [](const PointState<2> &s) { return s.pressure; };
    const auto          e       = [](const PointState<2> &s) { return s.energy; };
    const PointState<2> s       = flow.at(x, t);
    const auto          convect = [&](const auto &value) {
      return in_time(value) + s.velocity[0] * along(0, value) + s.velocity[1] * along(1, value);
    };
    double divergence = symmetry == Symmetry::axisymmetric ? s.velocity[0] / x[0] : 0.;
    for (int d = 0; d < 2; ++d)
      divergence += along(d, [d](const PointState<2> &q) { return q.velocity[d]; });
    Residual result;
    result.mass = convect(rho) + s.density * divergence;
    for (int d = 0; d < 2; ++d)
      result.momentum[d] = s.density * convect([d](const PointState<2> &q) { return q.velocity[d]; }) + along(d, p);
    result.energy = convect(e) + s.pressure / s.density * divergence;
    result.law    = exact::fluid_point(eos, s.density, s.energy).pressure - s.pressure;
    return result;
  }

  void
  expect_exact(const exact::ExactSolution<2> &flow, const EquationOfState &eos, Symmetry symmetry, double size,
               double t, double tolerance)
  {
    for (const double a : {0.13, 0.5, 0.9})
      for (const double b : {-0.7, 0.2, 0.6})
        {
          const Residual r = residual(flow, eos, symmetry, {{a * size, b * size}}, t, 1e-3 * size);
          EXPECT_NEAR(r.mass, 0., tolerance);
          EXPECT_NEAR(r.momentum[0], 0., tolerance);
          EXPECT_NEAR(r.momentum[1], 0., tolerance);
          EXPECT_NEAR(r.energy, 0., tolerance);
          EXPECT_NEAR(r.law, 0., tolerance);
        }
  }

  exact::ExactRequest<2>
  request(const std::string &name, const Material &material, double density, double energy)
  {
    exact::ExactRequest<2> result;
    result.name = name;
    exact::BodyState<2> body;
    body.material = material;
    body.density  = density;
    body.energy   = energy;
    result.bodies = {body};
    return result;
  }

  Material
  gas()
  {
    Material material;
    material.eos = std::make_shared<IdealGas>(1.4, 1.);
    return material;
  }

  Material
  metal()
  {
    Material material;
    material.eos = std::make_shared<MieGrueneisen>(MieGrueneisen::Constants{2.785, 0.5328, 1.338, 2.});
    return material;
  }

  exact::ExactRequest<2>
  gas_request(const std::string &name)
  {
    exact::ExactRequest<2> result                                   = request(name, gas(), 1., 2.5);
    result.bodies.front().constants.equation_of_state               = "ideal gas";
    result.bodies.front().constants.constants["Adiabatic exponent"] = 1.4;
    return result;
  }

  TEST(ExactVortex, SolvesTheEquationsOfMotion)
  {
    exact::ExactRequest<2> vortex = gas_request("isentropic vortex");
    vortex.constants              = {
                     {"Density", 1.}, {"Pressure", 1.}, {"Velocity along axis 0", 0.3}, {"Velocity along axis 1", -0.2},
                     {"Radius", 1.},  {"Speed", 0.6},   {"Centre along axis 0", 0.1},   {"Centre along axis 1", -0.1}};
    const auto flow = exact::make_isentropic_vortex(vortex);
    expect_exact(*flow, *gas().eos, Symmetry::planar, 1.5, 0.7, 1e-9);
    const PointState<2> rim = flow->at({{1.1, -0.1}}, 0.), centre = flow->at({{0.1, -0.1}}, 0.);
    EXPECT_NEAR(rim.velocity[1], -0.2 + 0.6, 1e-14);
    EXPECT_NEAR(rim.velocity[0], 0.3, 1e-14);
    EXPECT_NEAR(centre.pressure / std::pow(centre.density, 1.4), 1., 1e-13);
    EXPECT_NEAR(flow->at({{30., 0.}}, 0.).density, 1., 1e-15);

    vortex.constants["Speed"] = 2.;
    EXPECT_THROW(exact::make_isentropic_vortex(vortex), InputError);
    vortex.constants["Speed"] = 0.6;
    vortex.symmetry           = Symmetry::axisymmetric;
    EXPECT_THROW(exact::make_isentropic_vortex(vortex), InputError);
  }

  TEST(ExactEntropyWave, SolvesTheEquationsOfMotion)
  {
    for (const Symmetry symmetry : {Symmetry::planar, Symmetry::axisymmetric})
      {
        exact::ExactRequest<2> wave = request("entropy wave", metal(), 2.785, 1e-3);
        wave.symmetry               = symmetry;
        wave.constants              = {{"Density", 2.785},
                                       {"Pressure", 2.785 * 2. * 1e-3},
                                       {"Velocity along axis 0", 0.},
                                       {"Velocity along axis 1", 0.4},
                                       {"Radius", 0.5},
                                       {"Amplitude", 0.2},
                                       {"Centre along axis 0", 0.},
                                       {"Centre along axis 1", -0.3}};
        const auto flow             = exact::make_entropy_wave(wave);
        expect_exact(*flow, *metal().eos, symmetry, 0.5, 0.3, 1e-8);
        EXPECT_NEAR(flow->at({{0., -0.1}}, 0.5).density, 1.2 * 2.785, 1e-13);
        EXPECT_NEAR(flow->at({{0.5, -0.3}}, 0.).density, (1. + 0.2 / std::exp(1.)) * 2.785, 1e-13);

        wave.constants["Amplitude"] = -1.;
        EXPECT_THROW(exact::make_entropy_wave(wave), InputError);
        wave.constants["Amplitude"]           = 0.2;
        wave.constants["Centre along axis 0"] = 0.1;
        if (symmetry == Symmetry::axisymmetric)
          {
            EXPECT_THROW(exact::make_entropy_wave(wave), InputError);
          }
      }
  }

  TEST(ExactSoundWave, SolvesTheLinearEquations)
  {
    EXPECT_NEAR(exact::bessel_j1_zero(1), 3.8317059702075123, 1e-13); // [Abramowitz1964], table 9.5
    EXPECT_NEAR(exact::bessel_j1_zero(3), 10.173468135062722, 1e-13);
    for (const Symmetry symmetry : {Symmetry::planar, Symmetry::axisymmetric})
      {
        exact::ExactRequest<2> wave = request("sound wave", gas(), 1., 2.5);
        for (Boundary<2> &side : wave.boundaries)
          side.kind = BoundaryKind::reflecting;
        wave.symmetry   = symmetry;
        wave.lower      = {{0., -1.}};
        wave.upper      = {{1.5, 1.}};
        const double a  = 1e-4;
        wave.constants  = {{"Density", 1.},
                           {"Pressure", 1.},
                           {"Amplitude", a},
                           {"Half waves along axis 0", 1.},
                           {"Half waves along axis 1", 2.}};
        const auto flow = exact::make_sound_wave(wave);
        // what is left over is of second order in the amplitude
        expect_exact(*flow, *gas().eos, symmetry, 1., 0.3, 200. * a * a);
        // walls
        for (const double t : {0.1, 0.4})
          {
            EXPECT_NEAR(flow->at({{1.5, 0.3}}, t).velocity[0], 0., 1e-16);
            EXPECT_NEAR(flow->at({{0., 0.3}}, t).velocity[0], 0., 1e-16);
            EXPECT_NEAR(flow->at({{0.7, -1.}}, t).velocity[1], 0., 1e-16);
            EXPECT_NEAR(flow->at({{0.7, 1.}}, t).velocity[1], 0., 1e-16);
          }
        EXPECT_NEAR(flow->at({{0., -1.}}, 0.).density, 1. + a, 1e-15);

        wave.constants["Half waves along axis 1"] = 0.5;
        EXPECT_THROW(exact::make_sound_wave(wave), InputError);
        wave.constants["Half waves along axis 1"] = 2.;
        wave.boundaries[3].kind                   = BoundaryKind::transmitting;
        EXPECT_THROW(exact::make_sound_wave(wave), InputError);
      }
  }

  TEST(ExactRotation, SolvesTheEquationsOfMotion)
  {
    exact::ExactRequest<2> disc = request("rotation", metal(), 2.785, 0.);
    disc.bodies[0].lower        = {{-2., -1.5}};
    disc.bodies[0].upper        = {{2., 2.5}};
    disc.constants              = {{"Rim velocity", 0.05}};
    EXPECT_THROW(exact::make_rotation(disc), InputError);
    disc.bodies[0].round = true;
    const auto flow      = exact::make_rotation(disc);
    expect_exact(*flow, *metal().eos, Symmetry::planar, 1., 0., 1e-11);
    EXPECT_NEAR(flow->at({{2. - 1e-9, 0.5}}, 0.).velocity[1], 0.05, 1e-9);
    EXPECT_NEAR(flow->at({{0., 2.5 - 1e-9}}, 0.).velocity[0], -0.05, 1e-9);
    EXPECT_NEAR(flow->at({{0., 2.5 - 1e-9}}, 0.).pressure, 0., 1e-9);
    EXPECT_NEAR(flow->at({{0., 0.5}}, 0.).pressure, -0.5 * 2.785 * 0.05 * 0.05, 1e-15);
    EXPECT_EQ(flow->at({{1.6, 1.9}}, 0.).density, 0.);
  }

  TEST(ExactTranslation, CarriesBodiesAlong)
  {
    exact::ExactRequest<2> flight = request("translation", metal(), 2.785, 0.);
    exact::BodyState<2>    ball   = flight.bodies[0];
    ball.round                    = true;
    ball.lower                    = {{-1., 3.}};
    ball.upper                    = {{1., 5.}};
    ball.velocity                 = {{0., 0.5}};
    flight.bodies[0].lower        = {{0., 0.}};
    flight.bodies[0].upper        = {{4., 1.}};
    flight.bodies.push_back(ball);
    const auto solution = exact::make_translation(flight);
    EXPECT_EQ(solution->at({{0.7, 4.7}}, 0.).density, 2.785);
    EXPECT_EQ(solution->at({{0.75, 4.75}}, 0.).density, 0.);
    EXPECT_EQ(solution->at({{0.7, 5.2}}, 1.).velocity[1], 0.5);
    EXPECT_EQ(solution->at({{0.7, 3.7}}, 1.).density, 0.);
    EXPECT_EQ(solution->at({{3., 0.5}}, 9.).velocity[1], 0.);
    flight.bodies[0].energy = 1e-3;
    EXPECT_THROW(exact::make_translation(flight), InputError);
  }

  TEST(ExactVoidRate, ObeysTheRateLaw)
  {
    // phi_dot = -(alpha rho / gamma0^2) P_s
    for (const double ratio : {0.9, 1.2})
      {
        const exact::VoidRate::Constants constants{2.7, 0.652, 3., ratio * 2.7 * 0.7, 0.3};
        const exact::VoidRate            law(constants);
        EXPECT_NEAR(law.void_fraction(0.), 0.3, 1e-14);
        for (const double t : {0.05, 0.5, 2.})
          {
            const double rate = slope([&](double s) { return law.void_fraction(t + s); }, 1e-3);
            EXPECT_NEAR(rate, -3. * constants.bulk_density / (2.7 * 2.7) * law.solid_pressure(t), 1e-9);
          }
        EXPECT_NEAR(law.density_ratio(50.), 1., 1e-12);
      }
    // compressed beyond its reference density, the void closes
    const exact::VoidRate closing({2.7, 0.652, 3., 2.75, 0.02});
    EXPECT_NEAR(closing.void_fraction(closing.closing_time()), 0., 1e-12);
    EXPECT_TRUE(std::isinf(exact::VoidRate({2.7, 0.652, 3., 2.6, 0.}).closing_time()));
  }

  TEST(ExactVoidRate, FromAScene)
  {
    Material material;
    material.eos =
        std::make_shared<LinearPolynomial>(LinearPolynomial::Constants{.reference_density = 2.7, .c1 = 0.652});
    exact::ExactRequest<2> stretched = request("void relaxation", material, 2.6, 0.);
    EXPECT_THROW(exact::make_void_relaxation(stretched), InputError);
    exact::BodyState<2> &body         = stretched.bodies.front();
    body.constants.equation_of_state  = "linear polynomial";
    body.constants.constants["C1"]    = 0.652;
    body.constants.void_law           = "rate";
    body.constants.constants["Alpha"] = 3.;
    EXPECT_THROW(exact::make_void_relaxation(stretched), InputError); // the effect 'voids' is off
    body.material.void_law = std::make_shared<RateVoidLaw>(3., 0.);
    const auto solution    = exact::make_void_relaxation(stretched);
    EXPECT_NEAR(solution->at({{0., 0.}}, 0.).pressure, 0.652 * (2.6 / 2.7 - 1.), 1e-15);
    EXPECT_NEAR(solution->at({{0., 0.}}, 100.).pressure, 0., 1e-15);
    body.density = 2.8;
    EXPECT_THROW(exact::make_void_relaxation(stretched), InputError);
  }
} // namespace
