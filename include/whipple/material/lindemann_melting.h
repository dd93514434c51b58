// SPDX-License-Identifier: LGPL-2.1-or-later
#pragma once

#include <cmath>

namespace whipple
{
  /// Melting temperature of a solid over that at its reference density, by Lindemann's rule with Gamma varying as in
  /// [Steinberg1980]: exp[2 a (1 - v)] v^(-2 (Gamma0 - a - 1/3)), v = gamma0 / gamma.
  struct LindemannMelting
  {
    double grueneisen        = 0; ///< Gamma0
    double volume_correction = 0; ///< a

    double
    operator()(double v) const
    {
      return std::exp(2. * volume_correction * (1. - v) - exponent() * std::log(v));
    }

    /// d ln T_m / dv
    double
    logarithmic_slope(double v) const
    {
      return -2. * volume_correction - exponent() / v;
    }

  private:
    double
    exponent() const
    {
      return 2. * (grueneisen - volume_correction - 1. / 3.);
    }
  };
} // namespace whipple
