// SPDX-License-Identifier: LGPL-2.1-or-later
#pragma once

#include <whipple/exact/fluid_point.h>
#include <whipple/exact/profile.h>

#include <gtest/gtest.h>

#include <algorithm>
#include <cmath>
#include <functional>
#include <utility>

/// Any profile against the equations it claims to solve, without knowledge of how it was found.
namespace whipple::exact_check
{
  struct Flow
  {
    int                                                    dimensions; ///< 1 planar, 2 cylindrical, 3 spherical
    std::function<exact::FluidPoint(double rho, double e)> law;
  };

  /// Five-point derivative of f at 0.
  template <class F>
  double
  derivative(const F &f, double h)
  {
    return (8. * (f(h) - f(-h)) - (f(2. * h) - f(-2. * h))) / (12. * h);
  }

  /// Whether the solution is smooth within `reach` of a point, also within the time differences used there.
  inline bool
  smooth(const exact::Profile &profile, double x, double t, double reach)
  {
    for (const double time : {t - reach, t, t + reach})
      for (const double at : profile.breaks(time))
        if (std::abs(at - x) < 4. * reach)
          return false;
    return true;
  }

  /// Mass, momentum and energy,
  ///   rho_t + u rho_r + rho (u_r + (n - 1) u / r) = 0,   rho (u_t + u u_r) + p_r = 0,
  ///   e_t + u e_r + p / rho (u_r + (n - 1) u / r) = 0,
  /// by differences at `points` places of the range; each residual is compared with the terms it consists of.
  inline void
  expect_euler(const Flow &flow, const exact::Profile &profile, std::pair<double, double> range, double t,
               double tolerance = 1e-6, int points = 200)
  {
    const double h       = 1e-4 * (range.second - range.first);
    int          checked = 0;
    for (int i = 0; i < points; ++i)
      {
        const double x = range.first + (i + 0.5) / points * (range.second - range.first);
        if (!smooth(profile, x, t, 4. * h))
          continue;
        ++checked;
        const auto in_space = [&](double exact::ProfileState::*member) {
          return derivative([&](double d) { return profile.at(x + d, t).*member; }, h);
        };
        const auto in_time = [&](double exact::ProfileState::*member) {
          return derivative([&](double d) { return profile.at(x, t + d).*member; }, h);
        };
        using S                  = exact::ProfileState;
        const S      s           = profile.at(x, t);
        const double spread      = flow.dimensions > 1 ? (flow.dimensions - 1) * s.velocity / x : 0.;
        const double u_r         = in_space(&S::velocity);
        const auto   expect_zero = [&](const char *law, std::initializer_list<double> terms) {
          double sum = 0, size = 0;
          for (const double term : terms)
            {
              sum += term;
              size = std::max(size, std::abs(term));
            }
          EXPECT_LT(std::abs(sum), tolerance * size + 1e-9) << law << " at " << x << ", time " << t;
        };
        expect_zero("mass",
                    {in_time(&S::density), s.velocity * in_space(&S::density), s.density * u_r, s.density * spread});
        expect_zero("momentum",
                    {s.density * in_time(&S::velocity), s.density * s.velocity * u_r, in_space(&S::pressure)});
        expect_zero("energy", {in_time(&S::energy), s.velocity * in_space(&S::energy), s.pressure / s.density * u_r,
                               s.pressure / s.density * spread});
        EXPECT_NEAR(flow.law(s.density, s.energy).pressure, s.pressure, 1e-8 * std::abs(s.pressure) + 1e-12)
            << "equation of state at " << x;
      }
    EXPECT_GT(checked, points / 2) << "too few smooth places in the range";
  }

  /// Rankine-Hugoniot relations across the shock at a place, with its speed from the profile itself.
  inline void
  expect_shock(const exact::Profile &profile, double position, double t, double tolerance = 1e-6)
  {
    const double dt    = 1e-4 * std::abs(t);
    const double speed = derivative([&](double d) { return *profile.shock_position(t + d); }, dt);
    const double gap   = 1e-10 * std::max(1., std::abs(position));
    const auto   a = profile.at(position - gap, t), b = profile.at(position + gap, t);
    const double flux = a.density * (a.velocity - speed);
    EXPECT_NEAR(b.density * (b.velocity - speed), flux, tolerance * std::abs(flux)) << "mass";
    const double push = a.pressure + flux * a.velocity, other_push = b.pressure + flux * b.velocity;
    EXPECT_NEAR(other_push, push, tolerance * (a.pressure + b.pressure)) << "momentum";
    const double rise = a.energy - b.energy;
    EXPECT_NEAR(rise, 0.5 * (a.pressure + b.pressure) * (1. / b.density - 1. / a.density), tolerance * std::abs(rise))
        << "energy";
    EXPECT_GT(std::abs(a.density - b.density), 1e-3 * b.density) << "no shock there";
  }
} // namespace whipple::exact_check
