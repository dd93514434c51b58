// SPDX-License-Identifier: LGPL-2.1-or-later
#include <whipple/exact/isentrope.h>

#include <algorithm>
#include <array>
#include <cmath>
#include <utility>

namespace whipple::exact
{
  namespace
  {
    /// Step of the table in ln rho: its error in w and e is 1e-13 of their scale.
    constexpr double table_step = -1e-3;

    double
    falling_pressure(const Isentrope::Point &point)
    {
      return -point.fluid.pressure;
    }

    double
    ray_of(const Isentrope::Point &point)
    {
      return point.speed - point.fluid.sound_speed;
    }
  } // namespace

  Isentrope::Isentrope(std::shared_ptr<const EquationOfState> given_eos, const FluidPoint &start)
    : eos(std::move(given_eos))
  {
    if (!(start.sound_speed > 0))
      throw StateError(this->eos->name() + ": no real sound speed at " + std::to_string(start.density) +
                       " g/cm^3 and " + std::to_string(start.pressure) + " Mbar: it cannot expand");
    points.push_back({start, 0.});
    while (points.back().fluid.density > 1e-8 * start.density)
      {
        const Point next = step(points.back(), table_step);
        if (!(next.fluid.sound_speed > 0 && next.fluid.pressure < points.back().fluid.pressure))
          break;
        points.push_back(next);
      }
  }

  Isentrope::Point
  Isentrope::step(const Point &from, double length) const
  {
    const auto rate = [&](double logarithm, double energy) {
      const FluidPoint point = fluid_point(*eos, from.fluid.density * std::exp(logarithm), energy);
      return std::array<double, 2>{point.pressure / point.density, -point.sound_speed};
    };
    const double e = from.fluid.energy, half = 0.5 * length;
    const auto   a = rate(0., e), b = rate(half, e + half * a[0]), c = rate(half, e + half * b[0]),
               d      = rate(length, e + length * c[0]);
    const auto change = [&](int i) { return length / 6. * (a[i] + 2. * b[i] + 2. * c[i] + d[i]); };
    return {fluid_point(*eos, from.fluid.density * std::exp(length), e + change(0)), from.speed + change(1)};
  }

  template <class Value>
  Isentrope::Point
  Isentrope::find(double target, const Value &value) const
  {
    const auto   above = std::partition_point(points.begin() + 1, points.end() - 1,
                                              [&](const Point &point) { return value(point) < target; });
    const Point &from  = *(above - 1);
    // secants inside one step, where the value is all but linear
    double length = table_step, found = value(*above), last_length = 0., last = value(from);
    Point  point = *above;
    for (int i = 0; i < 6 && found != last; ++i)
      {
        const double next = length - (found - target) * (length - last_length) / (found - last);
        last_length       = std::exchange(length, std::clamp(next, table_step, 0.));
        last              = found;
        point             = step(from, length);
        found             = value(point);
      }
    return point;
  }

  Isentrope::Point
  Isentrope::at_pressure(double pressure) const
  {
    return find(-pressure, falling_pressure);
  }

  Isentrope::Point
  Isentrope::at_ray(double ray) const
  {
    return find(ray, ray_of);
  }

  bool
  Isentrope::rises_until(double pressure) const
  {
    for (std::size_t i = 1; i < points.size() && points[i - 1].fluid.pressure > pressure; ++i)
      if (!(ray_of(points[i]) > ray_of(points[i - 1])))
        return false;
    return true;
  }
} // namespace whipple::exact
