// SPDX-License-Identifier: LGPL-2.1-or-later
#pragma once

#include <whipple/material/conduction_law.h>

namespace whipple
{
  /// Fourier's law with one conductivity for solid, melt and vapour, doc/theory/heat_conduction.md.
  class ConstantConductivity : public ConductionLaw
  {
  public:
    /// @param conductivity k [Mbar cm^2/(us K)] > 0; 1 W/(m K) = 1e-13
    /// @throws InputError for values outside this range.
    explicit ConstantConductivity(double conductivity);

    void
    evaluate(std::span<const double> temperature, std::span<const double> melt_fraction,
             std::span<double> conductivity) const override;
    double
    reference_conductivity() const override;
    std::string
    name() const override;

  private:
    double conductivity_;
  };
} // namespace whipple
