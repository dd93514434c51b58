// SPDX-License-Identifier: LGPL-2.1-or-later
#pragma once

#include <whipple/material/aluminium_coexistence.h>

namespace whipple::aluminium_phases
{
  /// Where expansion ends the condensed phases: their density and stiffness gamma dP/dgamma|_e by energy, at zero
  /// pressure in the solid, in melting and in cold liquid, on the boiling curve in hot liquid; up to the critical
  /// energy.
  class ReleaseLine
  {
  public:
    ReleaseLine(const Melting &melting, const Boiling &boiling);

    /// Density [g/cm^3] and stiffness [Mbar] with their derivatives by energy.
    HermiteTable::Value
    density(double energy) const;
    HermiteTable::Value
    stiffness(double energy) const;

    /// Temperature on the line, and the mass share that is molten.
    double
    temperature(double energy) const;
    double
    melt_fraction(double energy) const;

    double melt_onset, melt_complete; ///< energies at zero pressure
    double vapour_onset;              ///< energy of liquid that boils at 1250 K, the cold end of the boiling curve
    double critical_energy;           ///< the end of the line

  private:
    double       melting_temperature_, solid_volume_, liquid_volume_;
    HermiteTable solid_density_, solid_stiffness_, fluid_density_, fluid_stiffness_;
  };
} // namespace whipple::aluminium_phases
