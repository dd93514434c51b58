// SPDX-License-Identifier: LGPL-2.1-or-later
#pragma once

#include <whipple/material/void_law.h>

#include <span>

namespace whipple
{
  /// Pressure of the solid [Mbar] below which material opens that has kept a share `soundness` of its spall strength
  /// [Mbar, may be infinite]; 0 where nothing is left.
  inline double
  opening_pressure(double spall_strength, double soundness)
  {
    return soundness > 0. ? -spall_strength * soundness : 0.; // infinity times 0 is not a number
  }

  /// One backward Euler step of d phi/dt = -(alpha rho / gamma0^2) P_s(rho / (1 - phi), e) at fixed bulk
  /// density rho and energy e, in every entry (doc/theory/voids.md).
  ///
  /// Entries with phi = 0 stay at exactly 0 unless P_s < opening_pressure(); entries with phi > 0 know no
  /// threshold. phi stays in [0, 1 - 2^-53]. An entry's result depends on that entry alone. Entries with
  /// rho <= 0, or whose pressure is not a number, are left as they are.
  ///
  /// @param alpha_dt alpha times the step [us^2/cm^2] >= 0; infinity: P_s = 0 or phi = 0 at the end.
  /// @param spall_strength [Mbar] >= 0; infinity: no void ever opens.
  /// @param void_fraction phi, in place, 0 <= phi < 1.
  void
  relax_void_fraction(const EquationOfState &eos, double alpha_dt, double spall_strength, const VoidInput &state,
                      std::span<double> void_fraction);
} // namespace whipple
