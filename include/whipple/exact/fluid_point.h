// SPDX-License-Identifier: LGPL-2.1-or-later
#pragma once

#include <whipple/material/equation_of_state.h>

namespace whipple::exact
{
  /// One thermodynamic state of a fluid without pores.
  struct FluidPoint
  {
    double density     = 0; ///< g/cm^3
    double energy      = 0; ///< Mbar cm^3/g
    double pressure    = 0; ///< Mbar
    double sound_speed = 0; ///< cm/us; 0 where the law has no real one
  };

  /// The state of density and energy under an equation of state.
  FluidPoint
  fluid_point(const EquationOfState &eos, double density, double energy);

  /// A state behind a shock.
  struct ShockedState
  {
    FluidPoint behind;
    double     velocity_jump; ///< of the material across the shock, >= 0, cm/us
    double     shock_speed;   ///< relative to the material ahead, cm/us
  };

  /// The shock that brings a fluid to a pressure, from the Rankine-Hugoniot relations: with v = 1 / rho,
  ///
  ///   e - e0 = (p + p0) (v0 - v) / 2,   (velocity jump)^2 = (p - p0) (v0 - v),   rho0 (shock speed) (jump) = p - p0.
  ///
  /// The density at which the law gives p on that line is found by bisection between rho0 and its maximum.
  /// @throws StateError unless p > p0 and there is such a density.
  ShockedState
  shock_to_pressure(const EquationOfState &eos, const FluidPoint &ahead, double pressure);
} // namespace whipple::exact
