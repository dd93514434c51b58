// SPDX-License-Identifier: LGPL-2.1-or-later
#pragma once

#include <whipple/exact/exact_factory.h>

namespace whipple::exact
{
  /// Vortex in an ideal gas of uniform entropy, steady in a frame that moves with the gas far away; planar. With x the
  /// distance vector from its centre, r = |x|, g = (k - 1)/2 (v_m / c0)^2 exp(1 - r^2 / R^2),
  ///
  ///   v = v0 + (v_m / R) exp((1 - r^2 / R^2) / 2) (-x_1, x_0),   c^2 = c0^2 (1 - g),
  ///   rho = rho0 (1 - g)^(1 / (k - 1)),   p = p0 (1 - g)^(k / (k - 1)):
  ///
  /// the enthalpy h = c^2 / (k - 1) obeys dh/dr = v_theta^2 / r. v_m is the largest speed about the centre, at r = R.
  /// doc/theory/exact_smooth.md.
  class IsentropicVortex : public ExactSolution<2>
  {
  public:
    struct Constants
    {
      double    exponent = 1.4; ///< k
      double    density  = 0;   ///< rho0, g/cm^3
      double    energy   = 0;   ///< of the gas far away, Mbar cm^3/g
      Vector<2> drift{};        ///< v0, cm/us
      Vector<2> centre{};       ///< at time 0, cm
      double    radius = 0;     ///< R, cm
      double    speed  = 0;     ///< v_m, cm/us
      double    start  = 0;     ///< time of the solution at the start of the run, us
    };

    IsentropicVortex(std::string name, const Constants &constants);

    PointState<2>
    at(const Vector<2> &x, double time) const override;

  private:
    Constants constants;
  };

  ExactKind
  isentropic_vortex_kind();

  /// The one body of the scene must be an ideal gas; planar.
  std::unique_ptr<const ExactSolution<2>>
  make_isentropic_vortex(const ExactRequest<2> &request);
} // namespace whipple::exact
