// SPDX-License-Identifier: LGPL-2.1-or-later
#pragma once

#include <whipple/material/void_law.h>

namespace whipple
{
  /// "Shifting equilibrium", the limit alpha -> infinity of the rate law: after each step P_s = 0 where there
  /// are voids, and phi = 0 where the material is compressed (doc/theory/voids.md).
  class EquilibriumVoidLaw : public VoidLaw
  {
  public:
    /// @param spall_strength [Mbar] >= 0: tension of the solid below which no void opens in sound material.
    /// @throws InputError for values outside this range.
    explicit EquilibriumVoidLaw(double spall_strength);

    /// dt does not matter: equilibrium is immediate.
    void
    advance(const EquationOfState &eos, double dt, const VoidInput &state,
            std::span<double> void_fraction) const override;
    std::string
    name() const override;

  private:
    double spall_strength;
  };
} // namespace whipple
