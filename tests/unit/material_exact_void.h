// SPDX-License-Identifier: LGPL-2.1-or-later
#pragma once

#include <cmath>

namespace whipple::testing_support
{
  /// Exact solution of the rate void law for P_s = K (g - 1), g = gamma / gamma0, at fixed bulk density:
  /// g' = -lambda g^2 (g - 1), lambda = alpha K / gamma0, hence
  /// lambda t = -[ln(|g - 1| / g) + 1/g] taken from g0 to g.
  /// @returns g after the dimensionless time lambda t.
  inline double
  exact_density_ratio(double g0, double lambda_t)
  {
    // In the logarithm of the distance to equilibrium, so that late times resolve too.
    const auto   clock  = [](double g) { return std::log(std::abs(g - 1.) / g) + 1. / g; };
    const double target = clock(g0) - lambda_t;
    const double sign   = g0 > 1. ? 1. : -1.;
    double near = std::log(std::abs(g0 - 1.)) - lambda_t * g0 * g0 - lambda_t - 2., far = std::log(std::abs(g0 - 1.));
    for (int i = 0; i < 200; ++i)
      {
        const double middle                                         = 0.5 * (near + far);
        (clock(1. + sign * std::exp(middle)) < target ? near : far) = middle;
      }
    return 1. + sign * std::exp(0.5 * (near + far));
  }
} // namespace whipple::testing_support
