// SPDX-License-Identifier: LGPL-2.1-or-later
#pragma once

#include <cmath>

namespace whipple::exact
{
  /// Density of the spherical point explosion in a uniform ideal gas (Sedov's closed form, notation of
  /// Kamm and Timmes, LA-UR-07-2849), for exponents k < 7 other than 2.
  class SedovSphere
  {
  public:
    SedovSphere(double exponent, double ambient_density, double shock_radius)
      : k_(exponent)
      , density_(ambient_density)
      , radius_(shock_radius)
    {
    }

    double
    density(double r) const
    {
      const double target = r / radius_;
      if (target > 1)
        return density_;
      double low = 2. / (5. * k_), high = 4. / (5. * (k_ + 1.));
      for (int i = 0; i < 100; ++i)
        {
          const double middle                        = 0.5 * (low + high);
          (similarity(middle) < target ? low : high) = middle;
        }
      const Terms  x  = terms(high);
      const double a2 = -(k_ - 1.) / (2. * (k_ - 1.) + 3.), denominator = 3. * (2. - k_);
      const double a1 = exponent_1(a2);
      return density_ * (k_ + 1.) / (k_ - 1.) * std::pow(x.x2, 3. / (2. * (k_ - 1.) + 3.)) *
             std::pow(x.x3, 15. * a1 / denominator) * std::pow(x.x4, -6. / denominator);
    }

  private:
    struct Terms
    {
      double x1, x2, x3, x4;
    };

    Terms
    terms(double v) const
    {
      const double b = (k_ + 1.) / (k_ - 1.), c = 2.5 * k_, e = 0.5 * (2. + 3. * (k_ - 1.));
      const double d = 5. * (k_ + 1.) / (5. * (k_ + 1.) - 2. * (2. + 3. * (k_ - 1.)));
      return {1.25 * (k_ + 1.) * v, b * (c * v - 1.), d * (1. - e * v), b * (1. - c * v / k_)};
    }
    double
    exponent_1(double a2) const
    {
      return 5. * k_ / (2. + 3. * (k_ - 1.)) * (6. * (2. - k_) / (k_ * 25.) - a2);
    }
    /// r / r_shock as a function of the similarity velocity.
    double
    similarity(double v) const
    {
      const Terms  x  = terms(v);
      const double a2 = -(k_ - 1.) / (2. * (k_ - 1.) + 3.);
      return std::pow(x.x1, -0.4) * std::pow(x.x2, -a2) * std::pow(x.x3, -exponent_1(a2));
    }

    double k_, density_, radius_;
  };
} // namespace whipple::exact
