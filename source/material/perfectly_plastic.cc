// SPDX-License-Identifier: LGPL-2.1-or-later
#include <whipple/material/common_constants.h>
#include <whipple/material/model_registry.h>
#include <whipple/material/parameter_check.h>
#include <whipple/material/perfectly_plastic.h>

#include <algorithm>

namespace whipple
{
  PerfectlyPlastic::PerfectlyPlastic(double shear_modulus, double yield_stress)
    : constant_shear_modulus(shear_modulus)
    , constant_yield_stress(yield_stress)
  {
    require_positive(name(), "shear modulus", shear_modulus, "Mbar");
    require_not_negative(name(), "yield stress", yield_stress, "Mbar");
  }

  void
  PerfectlyPlastic::evaluate(const StrengthInput &, std::span<double> shear_modulus,
                             std::span<double> yield_stress) const
  {
    std::fill(shear_modulus.begin(), shear_modulus.end(), constant_shear_modulus);
    std::fill(yield_stress.begin(), yield_stress.end(), constant_yield_stress);
  }

  double
  PerfectlyPlastic::reference_shear_modulus() const
  {
    return constant_shear_modulus;
  }

  std::string
  PerfectlyPlastic::name() const
  {
    return "perfectly plastic";
  }

  namespace
  {
    ModelDescription
    description()
    {
      return {
          .name    = "perfectly plastic",
          .summary = "constant shear modulus and yield stress",
          .documentation =
              "The deviatoric stress grows elastically with the shear modulus G and is limited to the von Mises "
              "surface "
              "of the yield stress Y. Neither hardens, stiffens nor softens: enough where the stress only has to be "
              "there, as in the wall of a shield.",
          .constants = {common_constants::shear_modulus, common_constants::yield_stress},
          .source    = "von Mises (1913); text-book",
          .published = {}};
    }

    const Registration<Strength> registration(description(), [](const ModelInput &c) {
      return std::make_shared<PerfectlyPlastic>(c("Shear modulus"), c("Yield stress"));
    });
  } // namespace
} // namespace whipple
