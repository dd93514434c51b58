// SPDX-License-Identifier: LGPL-2.1-or-later
#include <whipple/error.h>
#include <whipple/material/model_registry.h>
#include <whipple/material/rate_void_law.h>
#include <whipple/material/void_relaxation.h>

#include <sstream>

namespace whipple
{
  RateVoidLaw::RateVoidLaw(double given_alpha, double given_spall_strength)
    : alpha(given_alpha)
    , spall_strength(given_spall_strength)
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
  RateVoidLaw::advance(const EquationOfState &eos, double dt, const VoidInput &state,
                       std::span<double> void_fraction) const
  {
    if (dt > 0.)
      relax_void_fraction(eos, alpha * dt, spall_strength, state, void_fraction);
  }

  double
  RateVoidLaw::yielding(const EquationOfState &eos) const
  {
    return alpha / (eos.reference_density() * eos.reference_density());
  }

  std::shared_ptr<const VoidLaw>
  RateVoidLaw::with_growth(double new_alpha) const
  {
    return std::make_shared<RateVoidLaw>(new_alpha, spall_strength);
  }

  std::string
  RateVoidLaw::name() const
  {
    return "rate";
  }

  namespace
  {
    ModelDescription
    description()
    {
      return {
          .name    = "rate",
          .summary = "voids grow and close at the rate (8c) of the 1993 paper",
          .documentation =
              "d phi/dt = -(alpha rho / gamma0^2) P_s: tension of the solid opens voids, pressure closes them, and the "
              "work that this dissipates is heat. Sound material opens beyond the spall strength only; once there are "
              "voids there is no threshold until they have closed. Backward Euler: no Alpha limits the time step.",
          .constants = {{"Alpha", "void growth coefficient",
                         "alpha of the rate; 0 keeps every void as it is, infinite is the law 'equilibrium'",
                         Range::not_negative_or_infinite(), 1000., false},
                        {"Spall strength", "pressure", "tension of the solid beyond which sound material opens",
                         Range::not_negative_or_infinite(), 0., false}},
          .source    = "E. P. Fahrenthold, Int. J. Impact Engng 14 (1993) 229-240, (8c) as read in doc/theory/voids.md",
          .published = {}};
    }

    const Registration<VoidLaw> registration(description(), [](const ModelInput &c) {
      return std::make_shared<RateVoidLaw>(c("Alpha"), c("Spall strength"));
    });
  } // namespace
} // namespace whipple
