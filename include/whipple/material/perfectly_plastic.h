// SPDX-License-Identifier: LGPL-2.1-or-later
#pragma once

#include <whipple/material/strength.h>

namespace whipple
{
  /// Constant shear modulus G and yield stress Y [Mbar]. See doc/theory/strength.md.
  class PerfectlyPlastic : public Strength
  {
  public:
    /// @throws InputError unless G > 0 and Y >= 0.
    PerfectlyPlastic(double shear_modulus, double yield_stress);

    void
    evaluate(const StrengthInput &state, std::span<double> shear_modulus,
             std::span<double> yield_stress) const override;
    double
    reference_shear_modulus() const override;
    std::string
    name() const override;

  private:
    double constant_shear_modulus;
    double constant_yield_stress;
  };
} // namespace whipple
