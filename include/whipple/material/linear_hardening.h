// SPDX-License-Identifier: LGPL-2.1-or-later
#pragma once

#include <whipple/material/strength.h>

namespace whipple
{
  /// Constant shear modulus G, yield stress Y = Y0 + H eps_p [Mbar] growing with the equivalent plastic
  /// strain. H = dY/d(eps_p) is the plastic hardening modulus. See doc/theory/strength.md.
  class LinearHardening : public Strength
  {
  public:
    struct Constants
    {
      double shear_modulus     = 0; ///< G [Mbar], > 0
      double yield_stress      = 0; ///< Y0 [Mbar], >= 0
      double hardening_modulus = 0; ///< H [Mbar], >= 0
    };

    /// @throws InputError for constants outside their ranges.
    explicit LinearHardening(const Constants &constants);

    void
    evaluate(const StrengthInput &state, std::span<double> shear_modulus,
             std::span<double> yield_stress) const override;
    double
    reference_shear_modulus() const override;
    std::string
    name() const override;

  private:
    Constants constants;
  };
} // namespace whipple
