// SPDX-License-Identifier: LGPL-2.1-or-later
#pragma once

namespace whipple
{
  /// What resists shocks; doc/theory/viscosity.md compares them.
  enum class ViscosityKind
  {
    scalar, ///< a pressure in the cell
    tensor  ///< a stress in the directions of principal compression
  };

  /// Numerical constants of the Lagrange step; all dimensionless. Equations: doc/theory/lagrange_step.md.
  struct HydroParameters
  {
    ViscosityKind viscosity = ViscosityKind::scalar;

    double courant             = 0.5;  ///< share of the time a wave needs to cross a cell
    double linear_viscosity    = 0.2;  ///< c1 of the artificial viscosity
    double quadratic_viscosity = 1.33; ///< c2 of the artificial viscosity
    double hourglass           = 0.25; ///< kappa of the viscous hourglass resistance
    double max_volume_change   = 0.1;  ///< largest relative volume change of a cell in a step
  };
} // namespace whipple
