// SPDX-License-Identifier: LGPL-2.1-or-later
#pragma once

#include <whipple/material/equation_of_state.h>

#include <limits>
#include <memory>
#include <span>
#include <string>

namespace whipple
{
  /// What a void law needs of each cell.
  struct VoidInput
  {
    std::span<const double> bulk_density; ///< rho, g/cm^3; <= 0: nothing there
    std::span<const double> energy;       ///< specific internal energy, Mbar cm^3/g
    std::span<const double> soundness;    ///< share of the spall strength that is left (damage, melt); empty: all of it
  };

  /// How the void fraction phi of the mixture theory evolves over a step at frozen bulk density rho and
  /// energy e (doc/theory/voids.md). Implicit: no parameter of a law ever limits the time step.
  class VoidLaw
  {
  public:
    virtual ~VoidLaw() = default;

    /// Advance phi (in place, 0 <= phi < 1) by dt [us]. Entries with rho <= 0 are left alone.
    virtual void
    advance(const EquationOfState &eos, double dt, const VoidInput &state, std::span<double> void_fraction) const = 0;

    /// phi of a body that enters the scene unless it says otherwise.
    virtual double
    initial_void_fraction() const
    {
      return 0.;
    }

    /// A in dP_s/dt = -A gamma^2 c^2 P_s at frozen bulk density: how fast pores give way to the pressure of the solid
    /// (us cm^4/g^2: A gamma^2 c^2 is a rate, 1/us). 0: they withstand as the solid does, so the pressure
    /// of a porous cell follows its volume within a step; infinite: they give way at once, and it stays that of the
    /// start of the step.
    virtual double
    yielding(const EquationOfState & /*eos*/) const
    {
      return std::numeric_limits<double>::infinity();
    }

    /// The same law with another void growth coefficient alpha [us/cm^2]; null if the law has none.
    virtual std::shared_ptr<const VoidLaw>
    with_growth(double /*alpha*/) const
    {
      return nullptr;
    }

    /// Name in scene files, "rate", "equilibrium" ...
    virtual std::string
    name() const = 0;
  };
} // namespace whipple
