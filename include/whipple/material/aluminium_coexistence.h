// SPDX-License-Identifier: LGPL-2.1-or-later
#pragma once

#include <whipple/material/aluminium_phases.h>
#include <whipple/material/coexistence.h>

namespace whipple::aluminium_phases
{
  using Melting = Coexistence<Solid, Fluid>;
  using Boiling = Coexistence<Fluid, Fluid>;

  /// Solid and liquid from zero pressure to 18000 K; tau is the temperature.
  /// @throws StateError if the phases of the fit find no equilibrium.
  Melting
  melting_curve();

  /// Liquid and vapour from 1250 K, where the vapour pressure is below 1 Pa, to the critical point; tau is
  /// sqrt(1 - T/T_critical).
  /// @throws StateError as above.
  Boiling
  boiling_curve();

  struct CriticalPoint
  {
    double temperature, density;
  };

  /// Where an isotherm of the fluid has its first point of dP/dgamma = 0.
  CriticalPoint
  critical_point();
} // namespace whipple::aluminium_phases
