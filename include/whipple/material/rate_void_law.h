// SPDX-License-Identifier: LGPL-2.1-or-later
#pragma once

#include <whipple/material/void_law.h>

namespace whipple
{
  /// The rate law (8c) of the 1993 paper, as we read it, above a spall threshold:
  /// d phi/dt = -(alpha rho / gamma0^2) P_s, by backward Euler (doc/theory/voids.md).
  class RateVoidLaw : public VoidLaw
  {
  public:
    /// @param alpha [us/cm^2] >= 0: 0 keeps every void as it is, infinity is the equilibrium law.
    /// @param spall_strength [Mbar] >= 0: tension of the solid below which no void opens in sound material.
    /// @throws InputError for values outside these ranges.
    RateVoidLaw(double alpha, double spall_strength);

    void
    advance(const EquationOfState &eos, double dt, const VoidInput &state,
            std::span<double> void_fraction) const override;
    /// alpha / gamma0^2
    double
    yielding(const EquationOfState &eos) const override;
    std::shared_ptr<const VoidLaw>
    with_growth(double new_alpha) const override;
    std::string
    name() const override;

  private:
    double alpha;
    double spall_strength;
  };
} // namespace whipple
