// SPDX-License-Identifier: LGPL-2.1-or-later
#pragma once

#include <span>
#include <string>

namespace whipple
{
  /// Heat conductivity of a material.
  class ConductionLaw
  {
  public:
    virtual ~ConductionLaw() = default;

    /// k [Mbar cm^2/(us K)] of the solid from temperature [K] and melt fraction.
    virtual void
    evaluate(std::span<const double> temperature, std::span<const double> melt_fraction,
             std::span<double> conductivity) const = 0;

    /// k at reference conditions.
    virtual double
    reference_conductivity() const = 0;

    /// Name in scene files.
    virtual std::string
    name() const = 0;
  };
} // namespace whipple
