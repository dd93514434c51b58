// SPDX-License-Identifier: LGPL-2.1-or-later
#include <whipple/error.h>
#include <whipple/material/equilibrium_void_law.h>
#include <whipple/material/void_relaxation.h>

#include <limits>
#include <sstream>

namespace whipple
{
  EquilibriumVoidLaw::EquilibriumVoidLaw(double spall_strength)
    : spall_strength(spall_strength)
  {
    if (!(spall_strength >= 0.))
      {
        std::ostringstream message;
        message << "equilibrium void law: spall strength = " << spall_strength << " Mbar: must be >= 0";
        throw InputError(message.str());
      }
  }

  void
  EquilibriumVoidLaw::advance(const EquationOfState &eos, double, std::span<const double> bulk_density,
                              std::span<const double> energy, std::span<double> void_fraction) const
  {
    relax_void_fraction(eos, std::numeric_limits<double>::infinity(), spall_strength, bulk_density, energy,
                        void_fraction);
  }

  std::string
  EquilibriumVoidLaw::name() const
  {
    return "equilibrium";
  }
} // namespace whipple
