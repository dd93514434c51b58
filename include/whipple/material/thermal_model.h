// SPDX-License-Identifier: LGPL-2.1-or-later
#pragma once

#include <span>
#include <string>

namespace whipple
{
  /// Where a thermal model writes; an empty span is not wanted and not computed.
  struct ThermalOutput
  {
    std::span<double> temperature;      ///< K
    std::span<double> melt_temperature; ///< K, at this density
    std::span<double> melt_fraction;    ///< mass share of liquid (and vapour), 0 ... 1
    std::span<double> vapour_fraction;  ///< mass share of vapour, 0 ... 1
  };

  /// Temperature and phase of a material from true density [g/cm^3] and specific internal energy [Mbar cm^3/g].
  class ThermalModel
  {
  public:
    virtual ~ThermalModel() = default;

    virtual void
    evaluate(std::span<const double> density, std::span<const double> energy, const ThermalOutput &output) const = 0;

    /// False if it cannot tell temperatures after all (a table without them).
    virtual bool
    has_temperature() const
    {
      return true;
    }

    /// Specific heat at constant volume of the solid [Mbar cm^3/(g K)] at reference conditions.
    virtual double
    specific_heat() const = 0;

    /// Energies [Mbar cm^3/g above the reference state] at which the material begins to melt, is all molten, and begins
    /// and ends to boil at zero pressure; infinite where the model has no such transition.
    struct Transitions
    {
      double melt_onset, melt_complete, vapour_onset, vapour_complete;
    };
    virtual Transitions
    transitions() const = 0;

    /// Name in scene files.
    virtual std::string
    name() const = 0;
  };
} // namespace whipple
