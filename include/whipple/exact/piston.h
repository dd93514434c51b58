// SPDX-License-Identifier: LGPL-2.1-or-later
#pragma once

#include <whipple/exact/exact_factory.h>
#include <whipple/exact/uniaxial_loading.h>

#include <functional>

namespace whipple::exact
{
  /// A piston, a side of the domain that moves at constant velocity from t = 0 on, drives waves into a solid: constant
  /// states between the fronts of UniaxialLoading. What has passed the piston (a fixed mesh goes on behind it) has the
  /// state at the piston. Known until the first front comes back from the other end of the body.
  ///
  /// The piston of ep_piston [ExactPack] with the hypoelastic law; doc/theory/exact_solid.md.
  class Piston : public Profile
  {
  public:
    struct Constants
    {
      double origin     = 0; ///< side of the domain, cm
      double direction  = 1; ///< +1: the body lies above the piston, -1: below
      double far_end    = 0; ///< of the body, cm
      double velocity   = 0; ///< of the piston relative to the body, towards it, > 0, cm/us
      double body_speed = 0; ///< of the body before, along the axis, cm/us
    };

    /// @param loading what gives the material at rest, the fronts of a piston and the speed of waves: UniaxialLoading,
    ///        CompactionLoading.
    template <class Loading>
    Piston(const Loading &loading, const Constants &given_constants)
      : Piston(
            loading.initial(), loading.fronts(given_constants.velocity),
            [&loading](const LoadedState &state) { return loading.wave_speed(state); }, given_constants)
    {
    }

    ProfileState
    at(double coordinate, double time) const override;
    bool
    counts(double coordinate, double time) const override;
    std::vector<double>
    breaks(double time) const override;

    /// The front that brings the material to the velocity of the piston.
    std::optional<double>
    shock_position(double time) const override;

    /// Faster first.
    const std::vector<WaveFront> &
    fronts() const
    {
      return fronts_;
    }

  private:
    Piston(const LoadedState &ahead, std::vector<WaveFront> fronts,
           const std::function<double(const LoadedState &)> &wave_speed, const Constants &constants);

    /// Place of something that moves with a speed in the frame of the body, seen along `direction`.
    double
    place(double speed, double time) const;

    Constants              constants;
    LoadedState            ahead_;
    std::vector<WaveFront> fronts_;
    double                 arrival_;      ///< of the first front at the far end, us
    double                 return_speed_; ///< bound of what comes back from there, in the frame of the body, cm/us
  };

  /// The piston that a scene describes: the lower or upper side of axis 1, `inflow`, which the body touches.
  /// @throws InputError (one line, without file name) if it describes none.
  Piston::Constants
  piston_of_scene(const ExactRequest<2> &request, const BodyState<2> &body);

  ExactKind
  piston_kind();

  /// Material and state: the one body.
  std::unique_ptr<const ExactSolution<2>>
  make_piston(const ExactRequest<2> &request);
} // namespace whipple::exact
