// SPDX-License-Identifier: LGPL-2.1-or-later
#pragma once

#include <whipple/material/material.h>

#include <optional>
#include <vector>

namespace whipple::exact
{
  /// A solid in uniaxial strain. Stresses are positive in compression; the axial one is pressure + deviator.
  struct LoadedState
  {
    double density  = 0; ///< g/cm^3
    double pressure = 0; ///< mean stress, Mbar
    double deviator = 0; ///< deviatoric part of the axial stress, Mbar
    double energy   = 0; ///< Mbar cm^3/g
    double velocity = 0; ///< cm/us

    double
    stress() const
    {
      return pressure + deviator;
    }
  };

  /// A discontinuity and the state it leaves behind.
  struct WaveFront
  {
    double      speed = 0; ///< in the frame of the material ahead of all fronts, cm/us
    LoadedState behind;
  };

  /// Waves that a piston drives into a solid at rest: a plastic shock behind an elastic one, or one shock if the piston
  /// is slower than yielding needs, the material has no strength, or the plastic shock is the faster. Across a front of
  /// speed U from state a to state b, with s = pressure + deviator and V = 1 / density,
  ///
  ///   s_b - s_a = rho_a (U - v_a)(v_b - v_a),  (v_b - v_a)^2 = (s_b - s_a)(V_a - V_b),
  ///   e_b - e_a = (s_a + s_b)(V_a - V_b) / 2,  P_b = P_s(rho_b, e_b).
  ///
  /// The deviator follows the hypoelastic law, d = (4/3) G ln(rho / rho0) up to d = (2/3) Y, then the yield surface
  /// with the plastic strain of the path. doc/theory/exact_solid.md.
  class UniaxialLoading
  {
  public:
    /// @param density, energy of the solid at rest; it bears no deviatoric stress. G is that of this state.
    /// @throws InputError if the strength depends on more than the plastic strain.
    UniaxialLoading(const Material &material, double density, double energy);

    /// The material at rest.
    const LoadedState &
    initial() const
    {
      return initial_;
    }

    /// Fronts of a piston of this velocity > 0, the faster first.
    /// @throws InputError if no state of the material reaches this velocity.
    std::vector<WaveFront>
    fronts(double velocity) const;

    /// Axial stress at a piston of this velocity >= 0, Mbar.
    double
    stress(double velocity) const;

    /// Speed of longitudinal waves relative to the material, sqrt(c^2 + 4/3 G / rho), cm/us.
    double
    wave_speed(const LoadedState &state) const;

    bool
    has_strength() const
    {
      return shear_modulus_ > 0;
    }

  private:
    /// Deviator and (through it) plastic strain of a density reached in loading.
    double
    deviator(double density) const;

    /// State of this density behind a shock; none beyond the pole of the Hugoniot.
    std::optional<LoadedState>
    behind_shock(const LoadedState &ahead, double density) const;

    /// The front that brings the material ahead to a velocity.
    WaveFront
    shock(const LoadedState &ahead, double velocity) const;

    Material    material_;
    LoadedState initial_;
    double      shear_modulus_ = 0;
    double      yield_density_ = 0; ///< density at which yielding starts; infinite without
  };
} // namespace whipple::exact
