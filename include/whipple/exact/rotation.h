// SPDX-License-Identifier: LGPL-2.1-or-later
#pragma once

#include <whipple/exact/outline.h>

namespace whipple::exact
{
  /// A disc of fluid that rotates like a rigid body, planar. The centripetal force is that of its pressure: with a the
  /// distance from its centre, R its radius, v_R the velocity of its rim,
  ///
  ///   v_theta = v_R a / R,   rho = rho0,   p = p_R + (rho0 v_R^2 / 2) (a^2 / R^2 - 1),   P_s(rho0, e) = p:
  ///
  /// steady, and exact for any equation of state. A free disc has p_R = 0 and is under tension, which only the law of a
  /// solid bears. (A solid with strength bears its rotation by shear, which the initial state of a scene does not have:
  /// it would swing.) doc/theory/exact_smooth.md.
  class Rotation : public ExactSolution<2>
  {
  public:
    struct Constants
    {
      std::shared_ptr<const EquationOfState> eos;
      Outline                                disc;
      double                                 density      = 0; ///< rho0, g/cm^3
      double                                 rim_pressure = 0; ///< p_R, Mbar
      double                                 rim_velocity = 0; ///< v_R, anticlockwise, cm/us
    };

    Rotation(std::string name, const Constants &constants);

    /// Density 0 outside; the velocity goes on there, for nodes of cells that the rim cuts.
    PointState<2>
    at(const Vector<2> &x, double time) const override;

  private:
    Constants constants;
  };

  ExactKind
  rotation_kind();

  /// Disc: the one body of the scene, a sphere in planar symmetry, without velocity of its own.
  std::unique_ptr<const ExactSolution<2>>
  make_rotation(const ExactRequest<2> &request);
} // namespace whipple::exact
