// SPDX-License-Identifier: LGPL-2.1-or-later
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
  PerfectlyPlastic::evaluate(std::span<const double>, std::span<const double>, std::span<const double>,
                             std::span<double> shear_modulus, std::span<double> yield_stress) const
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
} // namespace whipple
