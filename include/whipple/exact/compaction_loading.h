// SPDX-License-Identifier: LGPL-2.1-or-later
#pragma once

#include <whipple/exact/uniaxial_loading.h>
#include <whipple/material/p_alpha_void_law.h>

#include <memory>
#include <optional>
#include <vector>

namespace whipple::exact
{
  /// Waves that a piston drives into porous material at rest, without strength, that crushes by the P-alpha law with a
  /// frozen distension below the crush curve: a compaction shock, behind an elastic precursor to the elastic crush
  /// pressure P_e unless the piston is too slow to crush (the precursor alone) or so fast that the shock from rest
  /// overtakes it. In the states, density and pressure are those of the bulk, rho = gamma / alpha and P = P_s(gamma, e)
  /// / alpha, and across a front, with V = 1 / rho,
  ///
  ///   P_b - P_a = rho_a (U - v_a)(v_b - v_a),  (v_b - v_a)^2 = (P_b - P_a)(V_a - V_b),
  ///   e_b - e_a = (P_a + P_b)(V_a - V_b) / 2,  alpha_b = alpha(P_b) on the crush curve.
  ///
  /// doc/theory/exact_solid.md.
  class CompactionLoading
  {
  public:
    /// @param density bulk, of the material at rest with the initial porosity of the law, g/cm^3
    /// @param energy  Mbar cm^3/g
    /// @throws InputError if that state is above the elastic crush pressure.
    CompactionLoading(std::shared_ptr<const EquationOfState> eos, const PAlphaVoidLaw::Constants &law, double density,
                      double energy);

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

    /// Speed of sound relative to the material at frozen distension, cm/us.
    double
    wave_speed(const LoadedState &state) const;

    /// alpha of material that has been brought to a bulk pressure.
    double
    distension(double pressure) const;

  private:
    /// State of this pressure behind a shock; none where the law has no such state.
    std::optional<LoadedState>
    behind_shock(const LoadedState &ahead, double pressure) const;

    /// The front that brings the material ahead to a velocity.
    WaveFront
    shock(const LoadedState &ahead, double velocity) const;

    std::shared_ptr<const EquationOfState> eos_;
    PAlphaVoidLaw::Constants               law_;
    LoadedState                            initial_;
  };
} // namespace whipple::exact
