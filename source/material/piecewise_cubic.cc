// SPDX-License-Identifier: LGPL-2.1-or-later
#include <whipple/material/piecewise_cubic.h>

#include <algorithm>
#include <cmath>

namespace whipple
{
  namespace
  {
    /// Derivative at x[k] of the polynomial through all points (Lagrange).
    double
    polynomial_slope(std::span<const double> x, std::span<const double> y, std::size_t k)
    {
      double slope = 0.;
      for (std::size_t i = 0; i < x.size(); ++i)
        if (i != k)
          {
            // of (y_i - y_k) times the i-th Lagrange polynomial; that y_k is taken off keeps the rounding small
            double weight = 1. / (x[i] - x[k]);
            for (std::size_t j = 0; j < x.size(); ++j)
              if (j != i && j != k)
                weight *= (x[k] - x[j]) / (x[i] - x[j]);
            slope += weight * (y[i] - y[k]);
          }
      return slope;
    }
  } // namespace

  std::vector<double>
  smooth_slopes(std::span<const double> x, std::span<const double> y)
  {
    const std::size_t   n     = x.size();
    const std::size_t   width = std::min<std::size_t>(5, n);
    std::vector<double> slopes(n);
    for (std::size_t i = 0; i < n; ++i)
      {
        const std::size_t begin = std::min(i < width / 2 ? 0 : i - width / 2, n - width);
        slopes[i]               = polynomial_slope(x.subspan(begin, width), y.subspan(begin, width), i - begin);
      }
    return slopes;
  }

  std::vector<double>
  monotone_slopes(std::span<const double> x, std::span<const double> y, double limit)
  {
    const std::size_t   last   = x.size() - 2; // interval
    std::vector<double> slopes = smooth_slopes(x, y);
    const auto          secant = [&](std::size_t i) { return (y[i + 1] - y[i]) / (x[i + 1] - x[i]); };
    for (std::size_t i = 0; i < x.size(); ++i)
      {
        const double left = secant(i == 0 ? 0 : i - 1), right = secant(std::min(i, last));
        const double bound = left * right > 0. ? limit * std::min(std::abs(left), std::abs(right)) : 0.;
        slopes[i]          = left > 0. ? std::clamp(slopes[i], 0., bound) : std::clamp(slopes[i], -bound, 0.);
      }
    return slopes;
  }
} // namespace whipple
