// SPDX-License-Identifier: LGPL-2.1-or-later
#pragma once

#include <span>
#include <string>

namespace whipple
{
  /// State of the solid that its strength depends on, one value a cell. Spans that a model does not ask for may be
  /// empty.
  struct StrengthInput
  {
    std::span<const double> density;        ///< true density gamma, g/cm^3
    std::span<const double> energy;         ///< specific internal energy, Mbar cm^3/g
    std::span<const double> pressure;       ///< P_s of the solid, Mbar; only if needs_pressure()
    std::span<const double> plastic_strain; ///< equivalent plastic strain
    std::span<const double> strain_rate;    ///< equivalent rate sqrt(2/3 D':D') of the deviatoric motion, 1/us; only if
                                            ///< needs_strain_rate()
  };

  /// Shear modulus and flow stress of the solid, without pores (the solver scales with 1 - phi).
  class Strength
  {
  public:
    virtual ~Strength() = default;

    /// Shear modulus G and yield stress Y in simple tension [Mbar].
    virtual void
    evaluate(const StrengthInput &state, std::span<double> shear_modulus, std::span<double> yield_stress) const = 0;

    virtual bool
    needs_pressure() const
    {
      return false;
    }
    virtual bool
    needs_strain_rate() const
    {
      return false;
    }

    /// True if Y falls to zero by itself where the material melts, and needs no SoftenedStrength around it.
    virtual bool
    softens() const
    {
      return false;
    }

    /// Shear modulus at reference conditions.
    virtual double
    reference_shear_modulus() const = 0;

    /// Name in scene files, "perfectly plastic" ...
    virtual std::string
    name() const = 0;
  };
} // namespace whipple
