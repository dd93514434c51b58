// SPDX-License-Identifier: LGPL-2.1-or-later
#include <whipple/exact/fluid_point.h>

#include <algorithm>
#include <cmath>

namespace whipple::exact
{
  FluidPoint
  fluid_point(const EquationOfState &eos, double density, double energy)
  {
    double pressure, square;
    eos.evaluate({&density, 1}, {&energy, 1}, {&pressure, 1}, {&square, 1});
    return {density, energy, pressure, std::sqrt(std::max(square, 0.))};
  }

  ShockedState
  shock_to_pressure(const EquationOfState &eos, const FluidPoint &ahead, double pressure)
  {
    const auto behind = [&](double density) {
      const double energy = ahead.energy + 0.5 * (pressure + ahead.pressure) * (1. / ahead.density - 1. / density);
      return fluid_point(eos, density, energy);
    };
    const auto fail = [&] {
      throw StateError(eos.name() + ": no shock from " + std::to_string(ahead.density) + " g/cm^3 and " +
                       std::to_string(ahead.pressure) + " Mbar to " + std::to_string(pressure) + " Mbar");
    };
    if (!(pressure > ahead.pressure))
      fail();
    // on the line p rises with the density from p0; towards a pole it rises without bound
    const double limit = eos.max_density();
    double       low = ahead.density, high = low;
    do
      {
        low  = high;
        high = std::isfinite(limit) ? 0.5 * (low + limit) : 2. * low;
        if (!(high > low && high < 1e6 * ahead.density && high < limit))
          fail();
      }
    while (behind(high).pressure < pressure);
    for (int i = 0; i < 100; ++i)
      {
        const double middle                               = 0.5 * (low + high);
        (behind(middle).pressure < pressure ? low : high) = middle;
      }
    const double shrinkage = 1. / ahead.density - 1. / high;
    const double jump      = std::sqrt((pressure - ahead.pressure) * shrinkage);
    return {behind(high), jump, jump / (ahead.density * shrinkage)};
  }
} // namespace whipple::exact
