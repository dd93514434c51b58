// SPDX-License-Identifier: LGPL-2.1-or-later
#pragma once

#include <whipple/error.h>

#include <limits>
#include <span>
#include <string>

namespace whipple
{
  /// Pressure law of the solid (or gas) itself, without pores: P_s(gamma, e) of true density gamma [g/cm^3]
  /// and specific internal energy e [Mbar cm^3/g], as a batch kernel over arrays.
  ///
  /// Implementations hold one loop a kernel, without branch on anything but the state, so that a value does
  /// not depend on its place in the array.
  class EquationOfState
  {
  public:
    virtual ~EquationOfState() = default;

    /// P_s [Mbar] and square of the isentropic sound speed
    /// c^2 = dP/dgamma|_e + (P/gamma^2) dP/de|_gamma [cm^2/us^2]. c^2 may be negative in states the law does
    /// not support (deep tension); callers bound it where they need a root.
    virtual void
    evaluate(std::span<const double> true_density, std::span<const double> energy, std::span<double> pressure,
             std::span<double> sound_speed_squared) const = 0;

    /// dP/dgamma at constant e and dP/de at constant gamma, for implicit solves.
    virtual void
    derivatives(std::span<const double> true_density, std::span<const double> energy, std::span<double> dp_ddensity,
                std::span<double> dp_de) const = 0;

    /// e with P_s(gamma, e) = pressure.
    /// @throws StateError where no such e exists.
    virtual double
    energy_of_pressure(double true_density, double pressure) const = 0;

    /// gamma0: density at P = 0, e = 0 for solids; a typical density for gases.
    virtual double
    reference_density() const = 0;

    /// Density [g/cm^3] that no pressure reaches under this law (the pole of a Hugoniot); infinite if there is
    /// none. evaluate() does not look: its values at and above this density mean nothing.
    virtual double
    max_density() const
    {
      return std::numeric_limits<double>::infinity();
    }

    /// For callers outside the hot loops.
    /// @throws StateError unless 0 < gamma < max_density().
    void
    check_density(double true_density) const
    {
      if (!(true_density > 0. && true_density < max_density()))
        throw StateError(name() + ": density " + std::to_string(true_density) + " g/cm^3 is outside (0, " +
                         std::to_string(max_density()) + ")");
    }

    /// Name in scene files, "mie-grueneisen".
    virtual std::string
    name() const = 0;
  };
} // namespace whipple
