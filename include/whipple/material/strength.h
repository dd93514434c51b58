// SPDX-License-Identifier: LGPL-2.1-or-later
#pragma once

#include <span>
#include <string>

namespace whipple
{
  /// Shear modulus and flow stress of the solid, without pores (the solver scales with 1 - phi).
  class Strength
  {
  public:
    virtual ~Strength() = default;

    /// Shear modulus G and yield stress Y in simple tension [Mbar] from true density, specific internal
    /// energy and equivalent plastic strain.
    virtual void
    evaluate(std::span<const double> gamma, std::span<const double> energy, std::span<const double> plastic_strain,
             std::span<double> shear_modulus, std::span<double> yield_stress) const = 0;

    /// Largest shear modulus the model can return at reference conditions, for time-step estimates.
    virtual double
    reference_shear_modulus() const = 0;

    /// Name in scene files, "perfectly plastic" ...
    virtual std::string
    name() const = 0;
  };
} // namespace whipple
