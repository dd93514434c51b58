// SPDX-License-Identifier: LGPL-2.1-or-later
#include <whipple/material/zero_pressure.h>

namespace whipple
{
  namespace
  {
    double
    pressure(const EquationOfState &eos, double v, double energy)
    {
      const double true_density = eos.reference_density() / v;
      double       p, square;
      eos.evaluate({&true_density, 1}, {&energy, 1}, {&p, 1}, {&square, 1});
      return p;
    }
  } // namespace

  std::optional<double>
  zero_pressure_volume(const EquationOfState &eos, double energy, double upper)
  {
    constexpr int steps = 400;
    double        low = 1., high = 1.;
    for (int i = 1; i <= steps && pressure(eos, high, energy) > 0.; ++i)
      {
        low  = high;
        high = 1. + (upper - 1.) * i / steps;
      }
    if (pressure(eos, high, energy) > 0.)
      return std::nullopt;
    for (int i = 0; i < 100; ++i)
      {
        const double middle                               = 0.5 * (low + high);
        (pressure(eos, middle, energy) > 0. ? low : high) = middle;
      }
    return high;
  }
} // namespace whipple
