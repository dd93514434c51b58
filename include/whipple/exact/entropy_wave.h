// SPDX-License-Identifier: LGPL-2.1-or-later
#pragma once

#include <whipple/exact/exact_factory.h>

namespace whipple::exact
{
  /// A smooth spot of other density (and so entropy) carried along by a flow of uniform pressure and velocity: with x
  /// the distance from the spot's centre, which moves with the flow,
  ///
  ///   rho = rho0 [1 + A exp(-|x|^2 / R^2)],   P_s(rho, e) = P_s(rho0, e0),   v = v0;
  ///
  /// planar and axisymmetric (v0 along axis 1 then), any equation of state, no strength. doc/theory/exact_smooth.md.
  class EntropyWave : public ExactSolution<2>
  {
  public:
    struct Constants
    {
      std::shared_ptr<const EquationOfState> eos;
      double                                 density = 0;   ///< rho0, g/cm^3
      double                                 energy  = 0;   ///< e0, Mbar cm^3/g
      Vector<2>                              velocity{};    ///< v0, cm/us
      Vector<2>                              centre{};      ///< of the spot at time 0, cm
      double                                 radius    = 0; ///< R, cm
      double                                 amplitude = 0; ///< A > -1
      double                                 start     = 0; ///< time of the solution at the start of the run, us
    };

    EntropyWave(std::string name, const Constants &constants);

    PointState<2>
    at(const Vector<2> &x, double time) const override;

  private:
    Constants constants;
    double    pressure_;
  };

  ExactKind
  entropy_wave_kind();

  /// The one body of the scene must not have strength.
  std::unique_ptr<const ExactSolution<2>>
  make_entropy_wave(const ExactRequest<2> &request);
} // namespace whipple::exact
