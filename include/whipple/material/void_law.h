// SPDX-License-Identifier: LGPL-2.1-or-later
#pragma once

#include <whipple/material/equation_of_state.h>

#include <span>
#include <string>

namespace whipple
{
  /// How the void fraction phi of the mixture theory evolves over a step at frozen bulk density rho and
  /// energy e (doc/theory/voids.md). Implicit: no parameter of a law ever limits the time step.
  class VoidLaw
  {
  public:
    virtual ~VoidLaw() = default;

    /// Advance phi (in place, 0 <= phi < 1) by dt [us]. Entries with rho <= 0 are left alone.
    virtual void
    advance(const EquationOfState &eos, double dt, std::span<const double> bulk_density, std::span<const double> energy,
            std::span<double> void_fraction) const = 0;

    /// Name in scene files, "rate", "equilibrium" ...
    virtual std::string
    name() const = 0;
  };
} // namespace whipple
