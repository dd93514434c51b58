// SPDX-License-Identifier: LGPL-2.1-or-later
#include <whipple/error.h>
#include <whipple/material/equilibrium_void_law.h>
#include <whipple/material/model_registry.h>
#include <whipple/material/void_relaxation.h>

#include <limits>
#include <sstream>

namespace whipple
{
  EquilibriumVoidLaw::EquilibriumVoidLaw(double given_spall_strength)
    : spall_strength(given_spall_strength)
  {
    if (!(spall_strength >= 0.))
      {
        std::ostringstream message;
        message << "equilibrium void law: spall strength = " << spall_strength << " Mbar: must be >= 0";
        throw InputError(message.str());
      }
  }

  void
  EquilibriumVoidLaw::advance(const EquationOfState &eos, double, const VoidInput &state,
                              std::span<double> void_fraction) const
  {
    relax_void_fraction(eos, std::numeric_limits<double>::infinity(), spall_strength, state, void_fraction);
  }

  std::string
  EquilibriumVoidLaw::name() const
  {
    return "equilibrium";
  }

  namespace
  {
    ModelDescription
    description()
    {
      return {.name    = "equilibrium",
              .summary = "voids open and close at once: no pressure where there are voids",
              .documentation =
                  "The limit alpha -> infinity of the law 'rate' (\"shifting equilibrium\"): at the end of every step "
                  "P_s = 0 "
                  "where there are voids, and there are none where the material is compressed. Sound material opens "
                  "beyond the spall strength only.",
              .constants = {{"Spall strength", "pressure", "tension of the solid beyond which sound material opens",
                             Range::not_negative_or_infinite(), 0., false}},
              .source    = "E. P. Fahrenthold, Int. J. Impact Engng 14 (1993) 229-240; doc/theory/voids.md",
              .published = {}};
    }

    const Registration<VoidLaw> registration(description(), [](const ModelInput &c) {
      return std::make_shared<EquilibriumVoidLaw>(c("Spall strength"));
    });
  } // namespace
} // namespace whipple
