// SPDX-License-Identifier: LGPL-2.1-or-later
#pragma once

#include <whipple/exact/exact_factory.h>

namespace whipple::exact
{
  /// Standing sound wave of small amplitude A in a box or (axisymmetric) a cylinder with rigid walls. With x_d the
  /// distance from the lower corner, l_d the edges of the domain, q_d the wave numbers and W = c sqrt(q_0^2 + q_1^2),
  ///
  ///   p = p0 + rho0 c^2 A S(q_0 x_0) cos(q_1 x_1) cos(W t),   rho = rho0 + (p - p0) / c^2,   e - e0 = p0 (rho - rho0)
  ///   / rho0^2, v_0 = -A (c^2 q_0 / W) S'(q_0 x_0) cos(q_1 x_1) sin(W t),   v_1 = A (c^2 q_1 / W) S(q_0 x_0) sin(q_1
  ///   x_1) sin(W t),
  ///
  /// S = cos, q_d = n_d pi / l_d in a box; S = J_0 in a cylinder, q_0 l_0 the n_0-th zero of J_1. Exact but for terms
  /// in A^2; any equation of state, no strength. doc/theory/exact_smooth.md.
  class SoundWave : public ExactSolution<2>
  {
  public:
    struct Constants
    {
      std::shared_ptr<const EquationOfState> eos;
      double                                 density  = 0; ///< rho0, g/cm^3
      double                                 energy   = 0; ///< e0, Mbar cm^3/g
      Symmetry                               symmetry = Symmetry::planar;
      Vector<2>                              lower{};       ///< corner of the domain, cm
      Vector<2>                              wave_number{}; ///< q, 1/cm
      double                                 amplitude = 0; ///< A
      double                                 start     = 0; ///< time of the solution at the start of the run, us
    };

    SoundWave(std::string name, const Constants &constants);

    PointState<2>
    at(const Vector<2> &x, double time) const override;

  private:
    Constants constants;
    double    pressure_, sound_speed_, frequency_;
  };

  ExactKind
  sound_wave_kind();

  /// The one body of the scene must not have strength, all sides of the domain must reflect.
  std::unique_ptr<const ExactSolution<2>>
  make_sound_wave(const ExactRequest<2> &request);

  /// The n-th positive zero of the Bessel function J_1, n >= 1.
  double
  bessel_j1_zero(int n);
} // namespace whipple::exact
