// SPDX-License-Identifier: LGPL-2.1-or-later
#pragma once

#include <whipple/exact/exact_factory.h>

#include <optional>

namespace whipple::exact
{
  /// Acoustic plate impact: a flyer of thickness h at velocity V strikes a target of thickness H > h of the same
  /// material, both free behind. d'Alembert's solution, with the velocity continued evenly beyond the free faces: in
  /// the coordinate X of the plates at contact (-h <= X <= H) and with v0 = V in the flyer, 0 in the target,
  ///
  ///   v = [v0(X - c t) + v0(X + c t)] / 2,   axial stress (positive in compression) = rho c [v0(X - c t) - v0(X + c
  ///   t)] / 2,
  ///
  /// of which the part K / (rho c^2) is pressure. Tension rho c V / 2 first appears at X = H - h, the distance h from
  /// the free face, at t = (H + h) / c. Where a tension S < rho c V / 2 already parts the material, it does so there
  /// and then, and the velocity of the free face, V until then, falls by 2 S / (rho c) (pull-back);
  /// doc/theory/exact_solid.md.
  class Spall : public Profile
  {
  public:
    struct Constants
    {
      double density      = 0; ///< rho, g/cm^3
      double bulk_modulus = 0; ///< K, Mbar
      double wave_speed   = 0; ///< c, longitudinal if the material has strength, cm/us
      double flyer        = 0; ///< h, cm
      double target       = 0; ///< H, cm
      double velocity     = 0; ///< V, cm/us
      double interface    = 0; ///< place of the contact at t = 0, cm
      double direction    = 1; ///< of V along the axis: +1 or -1
      double rest         = 0; ///< velocity of the target along the axis, cm/us
      double strength     = std::numeric_limits<double>::infinity(); ///< S: axial tension that parts the material, Mbar
    };

    explicit Spall(const Constants &constants);

    /// Density 0 outside of the plates.
    ProfileState
    at(double coordinate, double time) const override;

    /// Until what the spall plane sends out arrives.
    bool
    counts(double coordinate, double time) const override;
    std::vector<double>
    breaks(double time) const override;

    /// Axial stress in the frame of the plates, X as above; Mbar.
    double
    stress(double plate_coordinate, double time) const;

    /// Whether the material parts at all.
    bool
    spalls() const;

    /// Distance of the spall plane from the contact, H - h, cm.
    double
    spall_plane() const;

    /// When tension first acts there, us.
    double
    spall_time() const;

    /// Fall of the velocity of the free face, 2 S / (rho c), cm/us; V if nothing parts.
    double
    pull_back() const;

  private:
    /// v0 with its even continuation.
    double
    initial_velocity(double plate_coordinate) const;

    /// Integral of v, the displacement of a point of the plates, cm.
    double
    displacement(double plate_coordinate, double time) const;

    Constants constants;
  };

  ExactKind
  spall_kind();

  /// The two bodies of the scene, stacked along axis 1 and touching; the thinner is the flyer.
  std::unique_ptr<const ExactSolution<2>>
  make_spall(const ExactRequest<2> &request);
} // namespace whipple::exact
