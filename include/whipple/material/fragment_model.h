// SPDX-License-Identifier: LGPL-2.1-or-later
#pragma once

#include <span>
#include <string>

namespace whipple
{
  /// Size of the fragments that a material breaks into.
  class FragmentModel
  {
  public:
    virtual ~FragmentModel() = default;

    /// Fragment size [cm] of material that breaks while it expands.
    /// @param density      true density, g/cm^3
    /// @param sound_speed  bulk, cm/us
    /// @param strain_rate  rate of volume expansion at failure, 1/us
    /// @param melt_fraction share of the mass that is liquid; empty: all is solid
    virtual void
    evaluate(std::span<const double> density, std::span<const double> sound_speed, std::span<const double> strain_rate,
             std::span<const double> melt_fraction, std::span<double> size) const = 0;

    /// Name in scene files.
    virtual std::string
    name() const = 0;
  };
} // namespace whipple
