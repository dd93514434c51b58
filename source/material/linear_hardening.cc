// SPDX-License-Identifier: LGPL-2.1-or-later
#include <whipple/material/linear_hardening.h>
#include <whipple/material/parameter_check.h>

#include <algorithm>

namespace whipple
{
  LinearHardening::LinearHardening(const Constants &constants)
    : constants(constants)
  {
    require_positive(name(), "shear modulus", constants.shear_modulus, "Mbar");
    require_not_negative(name(), "yield stress", constants.yield_stress, "Mbar");
    require_not_negative(name(), "hardening modulus", constants.hardening_modulus, "Mbar");
  }

  void
  LinearHardening::evaluate(std::span<const double>, std::span<const double>, std::span<const double> plastic_strain,
                            std::span<double> shear_modulus, std::span<double> yield_stress) const
  {
    std::fill(shear_modulus.begin(), shear_modulus.end(), constants.shear_modulus);
    const double      yield0    = constants.yield_stress;
    const double      hardening = constants.hardening_modulus;
    const std::size_t n         = plastic_strain.size();
    for (std::size_t i = 0; i < n; ++i)
      yield_stress[i] = yield0 + hardening * plastic_strain[i];
  }

  double
  LinearHardening::reference_shear_modulus() const
  {
    return constants.shear_modulus;
  }

  std::string
  LinearHardening::name() const
  {
    return "linear hardening";
  }
} // namespace whipple
