// SPDX-License-Identifier: LGPL-2.1-or-later
#pragma once

#include <whipple/exact/exact_factory.h>
#include <whipple/exact/uniaxial_loading.h>

namespace whipple::exact
{
  /// A piston, a side of the domain that moves at constant velocity from t = 0 on, drives waves into a solid: constant
  /// states between the fronts of UniaxialLoading. What has passed the piston (a fixed mesh goes on behind it) has the
  /// state at the piston. Known until the first front comes back from the other end of the body.
  ///
  /// T. Lieberman's elastic-plastic piston of ExactPack with the hypoelastic law, REFERENCES C4;
  /// doc/theory/exact_solid.md.
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

    Piston(const UniaxialLoading &loading, const Constants &constants);

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
    /// Place of something that moves with a speed in the frame of the body, seen along `direction`.
    double
    place(double speed, double time) const;

    Constants              constants;
    LoadedState            ahead_;
    std::vector<WaveFront> fronts_;
    double                 arrival_;      ///< of the first front at the far end, us
    double                 return_speed_; ///< bound of what comes back from there, in the frame of the body, cm/us
  };

  ExactKind
  piston_kind();

  /// Piston: the lower or upper side of axis 1, `inflow`; material and state: the one body, which touches that side.
  std::unique_ptr<const ExactSolution<2>>
  make_piston(const ExactRequest<2> &request);
} // namespace whipple::exact
