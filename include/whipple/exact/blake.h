// SPDX-License-Identifier: LGPL-2.1-or-later
#pragma once

#include <whipple/exact/exact_factory.h>

namespace whipple::exact
{
  /// Blake's problem: from t = 0 on a constant pressure P acts inside a spherical cavity of radius a in a linear
  /// elastic solid of bulk modulus K and shear modulus G. With M = K + 4/3 G, c^2 = M / rho0, s = t - (r - a) / c >= 0,
  ///
  ///   u = -F'(s) / (c r) - F(s) / r^2,   F = -(P a^3 / 4G) [1 - exp(-b s)(cos w s + (b / w) sin w s)],
  ///   b = 2 G / (rho0 c a),   w^2 = 4 G / (rho0 a^2) - b^2,
  ///
  /// and what follows from the displacement u: velocity, stress, p = -K div u, rho = rho0 (1 - div u). Small strain,
  /// the coordinate is that of the undeformed solid.
  ///
  /// [Blake1952]; doc/theory/exact_solid.md.
  class Blake : public Profile
  {
  public:
    struct Constants
    {
      double density       = 0;                                       ///< rho0, g/cm^3
      double bulk_modulus  = 0;                                       ///< K, Mbar
      double shear_modulus = 0;                                       ///< G, Mbar
      double radius        = 0;                                       ///< a, cm
      double pressure      = 0;                                       ///< P, Mbar
      double rim           = std::numeric_limits<double>::infinity(); ///< outer radius of the solid, cm
    };

    /// Displacement and stresses (tension positive, as in the theory of elasticity).
    struct Elastic
    {
      double displacement = 0; ///< cm
      double velocity     = 0; ///< cm/us
      double dilatation   = 0; ///< div u
      double radial       = 0; ///< sigma_rr, Mbar
      double hoop         = 0; ///< sigma_tt, Mbar
    };

    explicit Blake(const Constants &constants);

    Elastic
    elastic(double radius, double time) const;

    ProfileState
    at(double coordinate, double time) const override;

    /// Until the front is back from the rim.
    bool
    counts(double coordinate, double time) const override;
    std::vector<double>
    breaks(double time) const override;

    double
    wave_speed() const
    {
      return wave_speed_;
    }

  private:
    Constants constants;
    double    wave_speed_, damping_, frequency_;
  };

  ExactKind
  blake_kind();

  /// Solid: the one body of the scene, which must have strength; radius and pressure of the cavity are constants.
  std::unique_ptr<const ExactSolution<2>>
  make_blake(const ExactRequest<2> &request);
} // namespace whipple::exact
