// SPDX-License-Identifier: LGPL-2.1-or-later
#include <whipple/material/reference_isentrope.h>

#include <algorithm>
#include <cmath>
#include <vector>

namespace whipple
{
  namespace
  {
    constexpr int    intervals     = 2048;
    constexpr int    steps_between = 4;   // Runge-Kutta steps from node to node
    constexpr double most_expanded = 10.; // gamma0 / gamma
    constexpr double most_dense    = 0.3;
    constexpr double off_the_pole  = 0.15; // share of the way from the pole of the law to gamma0 that is left out

    struct Isentrope
    {
      double energy, temperature;
    };

    struct Slopes
    {
      double energy, temperature; // d/dv
    };

    Slopes
    slopes(const EquationOfState &eos, double v, const Isentrope &at)
    {
      const double reference_density = eos.reference_density(), true_density = reference_density / v;
      double       pressure, square, dp_ddensity, dp_de;
      eos.evaluate({&true_density, 1}, {&at.energy, 1}, {&pressure, 1}, {&square, 1});
      eos.derivatives({&true_density, 1}, {&at.energy, 1}, {&dp_ddensity, 1}, {&dp_de, 1});
      return {-pressure / reference_density, -at.temperature * dp_de / reference_density};
    }

    Isentrope
    runge_kutta(const EquationOfState &eos, double v, const Isentrope &at, double step)
    {
      const auto along = [&](const Slopes &s, double h) {
        return Isentrope{at.energy + h * s.energy, at.temperature + h * s.temperature};
      };
      const Slopes k1 = slopes(eos, v, at);
      const Slopes k2 = slopes(eos, v + 0.5 * step, along(k1, 0.5 * step));
      const Slopes k3 = slopes(eos, v + 0.5 * step, along(k2, 0.5 * step));
      const Slopes k4 = slopes(eos, v + step, along(k3, step));
      return along({(k1.energy + 2. * k2.energy + 2. * k3.energy + k4.energy) / 6.,
                    (k1.temperature + 2. * k2.temperature + 2. * k3.temperature + k4.temperature) / 6.},
                   step);
    }

    Isentrope
    advance(const EquationOfState &eos, double from, Isentrope at, double to)
    {
      const double step = (to - from) / steps_between;
      for (int k = 0; k < steps_between; ++k)
        at = runge_kutta(eos, from + k * step, at, step);
      return at;
    }
  } // namespace

  ReferenceIsentrope::ReferenceIsentrope(const EquationOfState &eos, double specific_heat, double reference_temperature)
    : per_specific_heat_(1. / specific_heat)
  {
    const double pole  = eos.reference_density() / eos.max_density();
    const double wish  = std::max(most_dense, pole + off_the_pole * (1. - pole));
    const double step  = (most_expanded - wish) / intervals;
    const int    sound = static_cast<int>(std::lround((1. - wish) / step)); // node of gamma0
    lower_             = 1. - sound * step;
    upper_             = 1. + (intervals - sound) * step;

    std::vector<CubicTable::Node> nodes(intervals + 1);
    const auto                    volume = [&](int i) { return 1. + (i - sound) * step; };
    const auto                    keep   = [&](int i, const Isentrope &at) {
      const Slopes s = slopes(eos, volume(i), at);
      nodes[i] = {at.temperature - at.energy * per_specific_heat_, s.temperature - s.energy * per_specific_heat_};
    };
    const Isentrope reference{0., reference_temperature};
    keep(sound, reference);
    Isentrope at = reference;
    for (int i = sound + 1; i <= intervals; ++i)
      keep(i, at = advance(eos, volume(i - 1), at, volume(i)));
    at = reference;
    for (int i = sound - 1; i >= 0; --i)
      keep(i, at = advance(eos, volume(i + 1), at, volume(i)));
    offset_ = CubicTable(lower_, upper_, nodes);
  }
} // namespace whipple
