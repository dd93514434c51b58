// SPDX-License-Identifier: LGPL-2.1-or-later
#pragma once

#include <whipple/material/cubic_table.h>
#include <whipple/material/equation_of_state.h>

namespace whipple
{
  /// Temperature of a law of constant specific heat, T = e / cv + theta(v), v = gamma0 / gamma, with
  ///
  ///   theta = T_s - e_s / cv,   de_s/dv = -P(gamma, e_s) / gamma0,   dT_s/dv = -T_s (dP/de) / gamma0
  ///
  /// from e_s = 0, T_s = T_ref at gamma0: the isentrope through the reference state. Exactly what thermodynamics asks
  /// for wherever dP/de depends on gamma alone. Tabulated for lower() <= v <= upper(); theta keeps its end values
  /// outside. doc/theory/melting.md.
  class ReferenceIsentrope
  {
  public:
    /// @param specific_heat          cv > 0 [Mbar cm^3/(g K)]
    /// @param reference_temperature  of gamma0 and e = 0 [K]
    ReferenceIsentrope(const EquationOfState &eos, double specific_heat, double reference_temperature);

    /// K, without any change of phase.
    double
    temperature(double v, double energy) const
    {
      return energy * per_specific_heat_ + offset_(v);
    }

    /// Relative volumes gamma0 / gamma that the table spans.
    double
    lower() const
    {
      return lower_;
    }
    double
    upper() const
    {
      return upper_;
    }

  private:
    double     per_specific_heat_;
    double     lower_, upper_;
    CubicTable offset_; ///< theta [K] of v
  };
} // namespace whipple
