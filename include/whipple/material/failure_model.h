// SPDX-License-Identifier: LGPL-2.1-or-later
#pragma once

#include <span>
#include <string>

namespace whipple
{
  /// What happened to the solid over a step, one value a cell. Spans that a model does not ask for may be empty.
  struct FailureInput
  {
    std::span<const double> density;           ///< true density at the end of the step, g/cm^3
    std::span<const double> energy;            ///< Mbar cm^3/g
    std::span<const double> pressure;          ///< P_s of the solid, Mbar
    std::span<const double> void_fraction;     ///< phi at the end of the step; empty without voids
    std::span<const double> equivalent_stress; ///< sqrt(3/2 s:s), Mbar; empty without strength
    std::span<const double> plastic_increment; ///< of the equivalent plastic strain; empty without strength
    double                  dt = 0;            ///< us
  };

  /// Damage D of a material, 0 sound ... 1 failed; never heals. Failed material has no flow stress and opens voids
  /// under any tension (the solver scales both with 1 - D).
  class FailureModel
  {
  public:
    virtual ~FailureModel() = default;

    /// Advance D in place.
    virtual void
    advance(const FailureInput &state, std::span<double> damage) const = 0;

    /// True if it needs stress and plastic strain: then the material must have strength.
    virtual bool
    needs_strength() const
    {
      return false;
    }
    /// True if it needs phi: then the material must have a void law.
    virtual bool
    needs_voids() const
    {
      return false;
    }

    /// Name in scene files.
    virtual std::string
    name() const = 0;
  };
} // namespace whipple
