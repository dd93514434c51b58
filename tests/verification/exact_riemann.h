// SPDX-License-Identifier: LGPL-2.1-or-later
#pragma once

#include <cmath>

namespace whipple::exact
{
  /// Exact solution of the Riemann problem of one ideal gas; states are density, velocity, pressure.
  class Riemann
  {
  public:
    struct Primitive
    {
      double density, velocity, pressure;
    };

    Riemann(const Primitive &left, const Primitive &right, double exponent)
      : left_(left)
      , right_(right)
      , k_(exponent)
    {
      // the velocity jump across both waves rises monotonically with the pressure between them
      double low = 0, high = 1;
      while (velocity_gap(high) < 0)
        high *= 2;
      for (int i = 0; i < 200; ++i)
        {
          const double middle                     = 0.5 * (low + high);
          (velocity_gap(middle) < 0 ? low : high) = middle;
        }
      pressure_ = 0.5 * (low + high);
      velocity_ = left_.velocity - wave(left_, pressure_);
    }

    double
    pressure() const
    {
      return pressure_;
    }

    /// State on the ray x / t = s.
    Primitive
    operator()(double s) const
    {
      return s < velocity_ ? side(left_, s, 1.) : side(right_, s, -1.);
    }

    /// Mean density between the rays x / t = a and b: from -s rho' + (rho u)' = 0, the integral of rho over s is what
    /// rho (s - u) gains, shocks and contact included.
    double
    mean_density(double a, double b) const
    {
      const Primitive low = (*this)(a), high = (*this)(b);
      return (high.density * (b - high.velocity) - low.density * (a - low.velocity)) / (b - a);
    }

  private:
    /// Velocity change across a wave that brings a state to pressure p.
    double
    wave(const Primitive &state, double p) const
    {
      if (p > state.pressure)
        return (p - state.pressure) * std::sqrt(2. / (state.density * ((k_ + 1.) * p + (k_ - 1.) * state.pressure)));
      return 2. * sound(state) / (k_ - 1.) * (std::pow(p / state.pressure, (k_ - 1.) / (2. * k_)) - 1.);
    }
    double
    sound(const Primitive &state) const
    {
      return std::sqrt(k_ * state.pressure / state.density);
    }
    double
    velocity_gap(double p) const
    {
      return wave(left_, p) + wave(right_, p) + right_.velocity - left_.velocity;
    }

    /// Solution on the side of `state`; sign +1 left, -1 right of the contact.
    Primitive
    side(const Primitive &state, double s, double sign) const
    {
      const double ratio = pressure_ / state.pressure, c = sound(state);
      if (ratio > 1)
        {
          const double front =
              state.velocity - sign * c * std::sqrt((k_ + 1.) / (2. * k_) * ratio + (k_ - 1.) / (2. * k_));
          const double jump = (k_ - 1.) / (k_ + 1.);
          if (sign * (s - front) < 0)
            return state;
          return {state.density * (ratio + jump) / (jump * ratio + 1.), velocity_, pressure_};
        }
      const double c_star = c * std::pow(ratio, (k_ - 1.) / (2. * k_));
      if (sign * (s - (state.velocity - sign * c)) < 0)
        return state;
      if (sign * (s - (velocity_ - sign * c_star)) > 0)
        return {state.density * std::pow(ratio, 1. / k_), velocity_, pressure_};
      const double c_fan = (2. * c + sign * (k_ - 1.) * (state.velocity - s)) / (k_ + 1.);
      return {state.density * std::pow(c_fan / c, 2. / (k_ - 1.)), s + sign * c_fan,
              state.pressure * std::pow(c_fan / c, 2. * k_ / (k_ - 1.))};
    }

    Primitive left_, right_;
    double    k_, pressure_ = 0, velocity_ = 0;
  };
} // namespace whipple::exact
