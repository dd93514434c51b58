// SPDX-License-Identifier: LGPL-2.1-or-later
#pragma once

#include <whipple/exact/fluid_point.h>

#include <memory>
#include <vector>

namespace whipple::exact
{
  /// Isentropic expansion of a fluid, tabulated once:
  ///
  ///   de / d ln rho = p / rho,   dw / d ln rho = -c,
  ///
  /// by the classical Runge-Kutta scheme in ln rho; w is the speed that a simple wave gives the material. It ends where
  /// the density has fallen by 1e8 or the law has no real sound speed any more.
  class Isentrope
  {
  public:
    struct Point
    {
      FluidPoint fluid;
      double     speed = 0; ///< w, cm/us
    };

    /// @throws StateError if the fluid has no real sound speed to start with.
    Isentrope(std::shared_ptr<const EquationOfState> eos, const FluidPoint &start);

    /// The most expanded state of the table.
    const Point &
    end() const
    {
      return points.back();
    }

    /// State of a pressure between those of start and end().
    Point
    at_pressure(double pressure) const;

    /// State with w - c as given: in a centred wave that runs to the left through material at rest the ray x/t = w - c.
    /// Only where w - c rises all along the wave (rises_until()).
    Point
    at_ray(double ray) const;

    /// Whether w - c rises from the start to a pressure: otherwise the wave is no simple rarefaction.
    bool
    rises_until(double pressure) const;

  private:
    Point
    step(const Point &from, double length) const;
    template <class Value>
    Point
    find(double target, const Value &value) const;

    std::shared_ptr<const EquationOfState> eos;
    std::vector<Point>                     points; ///< from the start on
  };
} // namespace whipple::exact
