// SPDX-License-Identifier: LGPL-2.1-or-later
#pragma once

#include <whipple/exact/isentrope.h>
#include <whipple/exact/piston.h>

#include <array>

namespace whipple::exact
{
  /// Two plates, stacked along axis 1, of the same material or not, with strength or not, collide. Their common face
  /// then moves at the velocity u at which both bear the same axial stress; to each plate it is a piston. A plate
  /// without strength is followed on through the release of its rear face, a centred fan into the vacuum; of one with
  /// strength, what the first reflected wave has reached is not known. Nor is what releases that cross the common face
  /// have reached.
  ///
  /// doc/theory/exact_solid.md.
  class PlateImpact : public Profile
  {
  public:
    struct Plate
    {
      UniaxialLoading                        loading;
      std::shared_ptr<const EquationOfState> eos;
      double                                 lower = 0, upper = 0; ///< faces at t = 0, cm
      double                                 velocity = 0;         ///< along the axis, cm/us
    };

    /// @throws InputError if the plates do not approach each other.
    PlateImpact(const Plate &lower, const Plate &upper);

    ProfileState
    at(double coordinate, double time) const override;
    bool
    counts(double coordinate, double time) const override;

    /// Fronts, ends of the release fans, common face.
    std::vector<double>
    breaks(double time) const override;

    /// The last front of the upper plate.
    std::optional<double>
    shock_position(double time) const override;

    /// Velocity of the common face, cm/us.
    double
    interface_velocity() const
    {
      return interface_velocity_;
    }

  private:
    /// The release of a rear face; speeds are distance from where it began over the time since, outwards positive.
    struct Fan
    {
      std::shared_ptr<const Isentrope> isentrope;
      double                           shocked = 0; ///< velocity of the material before
      double                           head = 0, tail = 0, surface = 0;
    };

    /// One plate from the moment of contact on, seen from the common face outwards.
    struct Side
    {
      double                direction = 0; ///< outwards along the axis: -1 lower plate, +1 upper plate
      double                near = 0, far = 0, velocity = 0;
      LoadedState           rest;
      std::optional<Piston> waves;
      std::optional<Fan>    fan;
      double                arrival  = 0; ///< of the first front at the far face, after contact, us
      double                face     = 0; ///< where that is, cm
      double                inwards  = 0; ///< bound of waves that run inwards, > 0 towards the common face, cm/us
      double                outwards = 0; ///< bound of waves that run outwards, cm/us
      double                crossing = 0; ///< when the release of this side reaches the common face, after contact
    };

    Side
    make_side(const Plate &plate, double direction) const;

    ProfileState
    in_side(const Side &side, double coordinate, double since) const;

    double              contact_time_       = 0;
    double              contact_place_      = 0;
    double              interface_velocity_ = 0;
    std::array<Side, 2> sides_;
  };

  ExactKind
  plate_impact_kind();

  /// The two bodies of the scene, which lie one above the other along axis 1 and fill the domain sideways.
  std::unique_ptr<const ExactSolution<2>>
  make_plate_impact(const ExactRequest<2> &request);
} // namespace whipple::exact
