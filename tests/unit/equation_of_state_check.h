// SPDX-License-Identifier: LGPL-2.1-or-later
#pragma once

#include <whipple/material/equation_of_state.h>

#include <gtest/gtest.h>

#include <array>
#include <cmath>
#include <cstring>
#include <vector>

/// What every equation of state promises, checked from its pressure alone.
namespace whipple::eos_check
{
  struct State
  {
    double true_density, e;
  };

  inline double
  pressure(const EquationOfState &eos, double true_density, double e)
  {
    double p, c2;
    eos.evaluate({&true_density, 1}, {&e, 1}, {&p, 1}, {&c2, 1});
    return p;
  }

  inline double
  sound_speed_squared(const EquationOfState &eos, double true_density, double e)
  {
    double p, c2;
    eos.evaluate({&true_density, 1}, {&e, 1}, {&p, 1}, {&c2, 1});
    return c2;
  }

  /// Central difference of fourth order of a function of one number.
  template <class Function>
  double
  slope(const Function &f, double x, double h)
  {
    return (8. * (f(x + h) - f(x - h)) - (f(x + 2. * h) - f(x - 2. * h))) / (12. * h);
  }

  /// dP/dgamma, dP/de and c^2 against differences of P. The tolerance is relative to the terms that make up c^2; the
  /// steps are fractions of gamma and of |e| + energy_scale.
  inline void
  expect_exact_derivatives(const EquationOfState &eos, const State &state, double energy_scale, double tolerance,
                           double step = 3e-4)
  {
    const auto [true_density, e] = state;
    SCOPED_TRACE(eos.name() + " density " + std::to_string(true_density) + " e " + std::to_string(e));
    const double by_density = slope([&](double g) { return pressure(eos, g, e); }, true_density, step * true_density);
    const double by_e =
        slope([&](double x) { return pressure(eos, true_density, x); }, e, step * (std::abs(e) + energy_scale));

    double dp_ddensity, dp_de;
    eos.derivatives({&true_density, 1}, {&e, 1}, {&dp_ddensity, 1}, {&dp_de, 1});
    const double work  = pressure(eos, true_density, e) / (true_density * true_density);
    const double scale = std::abs(by_density) + (std::abs(work) + energy_scale / true_density) * std::abs(by_e);
    EXPECT_NEAR(dp_ddensity, by_density, tolerance * scale);
    EXPECT_NEAR(dp_de, by_e, tolerance * (std::abs(by_e) + std::abs(by_density) * true_density / energy_scale));
    EXPECT_NEAR(sound_speed_squared(eos, true_density, e), by_density + work * by_e, tolerance * scale);
    // Both kernels mean the same derivatives.
    EXPECT_NEAR(sound_speed_squared(eos, true_density, e), dp_ddensity + work * dp_de, 1e-12 * scale);
  }

  /// Along an isentrope, de = P dgamma/gamma^2 by Runge-Kutta, the pressure rises by the integral of c^2 dgamma.
  inline void
  expect_isentropic(const EquationOfState &eos, const State &from, double density_to, int steps, double tolerance)
  {
    SCOPED_TRACE(eos.name() + " isentrope from gamma " + std::to_string(from.true_density) + " e " +
                 std::to_string(from.e));
    const double h    = (density_to - from.true_density) / steps;
    const auto   rate = [&](double true_density, double e) {
      double p, c2;
      eos.evaluate({&true_density, 1}, {&e, 1}, {&p, 1}, {&c2, 1});
      return std::array<double, 2>{p / (true_density * true_density), c2};
    };
    double true_density = from.true_density, e = from.e, rise = 0.;
    for (int i = 0; i < steps; ++i)
      {
        const auto a = rate(true_density, e);
        const auto b = rate(true_density + h / 2, e + h / 2 * a[0]);
        const auto c = rate(true_density + h / 2, e + h / 2 * b[0]);
        const auto d = rate(true_density + h, e + h * c[0]);
        e += h / 6 * (a[0] + 2 * b[0] + 2 * c[0] + d[0]);
        rise += h / 6 * (a[1] + 2 * b[1] + 2 * c[1] + d[1]);
        true_density = from.true_density + (i + 1) * h;
      }
    const double expected = pressure(eos, true_density, e) - pressure(eos, from.true_density, from.e);
    EXPECT_NEAR(rise, expected, tolerance * std::abs(expected));
  }

  /// e(gamma, P(gamma, e)) gives P back, and e itself where P is monotone in e.
  inline void
  expect_inverse(const EquationOfState &eos, const State &state, double energy_scale, double tolerance)
  {
    SCOPED_TRACE(eos.name() + " density " + std::to_string(state.true_density) + " e " + std::to_string(state.e));
    const double e = eos.energy_of_pressure(state.true_density, pressure(eos, state.true_density, state.e));
    EXPECT_NEAR(e, state.e, tolerance * (std::abs(state.e) + energy_scale));
  }

  /// Every offset of a batch, so vector loop and remainder, gives the bits of single cells.
  inline void
  expect_batch_is_scalar(const EquationOfState &eos, const std::vector<State> &states)
  {
    std::vector<double> true_density, e;
    for (int copy = 0; copy < 3; ++copy)
      for (const State &state : states)
        {
          true_density.push_back(state.true_density * (1. + 1e-3 * copy));
          e.push_back(state.e);
        }
    const std::size_t   n = true_density.size();
    std::vector<double> p(n), c2(n), dp_ddensity(n), dp_de(n);
    const auto          same = [](double a, double b) { return std::memcmp(&a, &b, sizeof(double)) == 0; };
    for (std::size_t start = 0; start < std::min<std::size_t>(n, 9); ++start)
      {
        const std::size_t             m = n - start;
        const std::span<const double> g = std::span<const double>(true_density).subspan(start);
        const std::span<const double> x = std::span<const double>(e).subspan(start);
        eos.evaluate(g, x, std::span(p).first(m), std::span(c2).first(m));
        eos.derivatives(g, x, std::span(dp_ddensity).first(m), std::span(dp_de).first(m));
        for (std::size_t i = 0; i < m; ++i)
          {
            double one_p, one_c2, one_dp_ddensity, one_dp_de;
            eos.evaluate({&g[i], 1}, {&x[i], 1}, {&one_p, 1}, {&one_c2, 1});
            eos.derivatives({&g[i], 1}, {&x[i], 1}, {&one_dp_ddensity, 1}, {&one_dp_de, 1});
            EXPECT_TRUE(same(p[i], one_p) && same(c2[i], one_c2) && same(dp_ddensity[i], one_dp_ddensity) &&
                        same(dp_de[i], one_dp_de))
                << eos.name() << " density " << g[i] << " e " << x[i];
          }
      }
  }
} // namespace whipple::eos_check
