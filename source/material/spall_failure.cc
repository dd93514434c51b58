// SPDX-License-Identifier: LGPL-2.1-or-later
#include <whipple/error.h>
#include <whipple/material/failure_constants.h>
#include <whipple/material/model_registry.h>
#include <whipple/material/spall_failure.h>

namespace whipple
{
  SpallFailure::SpallFailure(double void_fraction)
    : void_fraction_(void_fraction)
  {
    if (!(void_fraction >= 0. && void_fraction < 1.))
      throw InputError(name() + ": failure void fraction = " + std::to_string(void_fraction) +
                       ": must be >= 0 and < 1");
  }

  void
  SpallFailure::advance(const FailureInput &state, std::span<double> damage) const
  {
    const std::size_t n = damage.size();
    for (std::size_t i = 0; i < n; ++i)
      damage[i] = state.void_fraction[i] > void_fraction_ ? 1. : damage[i];
  }

  bool
  SpallFailure::needs_voids() const
  {
    return true;
  }

  std::string
  SpallFailure::name() const
  {
    return "spall";
  }

  namespace
  {
    ModelDescription
    description()
    {
      return {
          .name    = "spall",
          .summary = "material that has opened stays broken: its spall strength never comes back",
          .documentation =
              "D = 1 once the void fraction exceeds a threshold, for good: when the voids close again the material is "
              "rubble, which any tension opens and which has no yield stress. The strength itself, the tension at "
              "which "
              "sound material opens, is the void law's. Needs a void law.",
          .constants = {common_constants::failure_void_fraction},
          .source    = "doc/theory/failure.md",
          .published = {}};
    }

    const Registration<FailureModel> registration(description(), [](const ModelInput &c) {
      return std::make_shared<SpallFailure>(c("Failure void fraction"));
    });
  } // namespace
} // namespace whipple
