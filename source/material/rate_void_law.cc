// SPDX-License-Identifier: LGPL-2.1-or-later
#include <whipple/error.h>
#include <whipple/material/rate_void_law.h>
#include <whipple/material/void_relaxation.h>

#include <sstream>

namespace whipple
{
  RateVoidLaw::RateVoidLaw(double alpha, double spall_strength)
    : alpha(alpha)
    , spall_strength(spall_strength)
  {
    // Infinity has a meaning for both: equilibrium, and material that does not spall.
    std::ostringstream message;
    if (!(alpha >= 0.))
      message << "rate void law: alpha = " << alpha << " us/cm^2: must be >= 0";
    else if (!(spall_strength >= 0.))
      message << "rate void law: spall strength = " << spall_strength << " Mbar: must be >= 0";
    else
      return;
    throw InputError(message.str());
  }

  void
  RateVoidLaw::advance(const EquationOfState &eos, double dt, std::span<const double> bulk_density,
                       std::span<const double> energy, std::span<double> void_fraction) const
  {
    if (dt > 0.)
      relax_void_fraction(eos, alpha * dt, spall_strength, bulk_density, energy, void_fraction);
  }

  std::string
  RateVoidLaw::name() const
  {
    return "rate";
  }
} // namespace whipple
