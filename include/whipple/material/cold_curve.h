// SPDX-License-Identifier: LGPL-2.1-or-later
#pragma once

#include <whipple/material/equation_of_state.h>

#include <vector>

namespace whipple
{
  /// Least specific internal energy that matter can have at a density, if it began at or above a state and has since
  /// only been compressed, released, sheared and heated: the isentrope de/dgamma = P_s(gamma, e) / gamma^2 from that
  /// state, on the side of compression. Below the density of the state the bound is the energy of the state itself.
  /// doc/theory/guards.md.
  class ColdCurve
  {
  public:
    /// @param density gamma of the state, g/cm^3   @param energy of it, Mbar cm^3/g
    ColdCurve(const EquationOfState &eos, double density, double energy);

    /// Mbar cm^3/g; linear in log(gamma) between the points of the table, beyond the last one that one's.
    double
    energy(double true_density) const;

  private:
    double              density_; ///< where the table begins
    double              step_;    ///< of log(gamma) between its points
    std::vector<double> energy_;
  };
} // namespace whipple
