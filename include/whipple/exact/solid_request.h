// SPDX-License-Identifier: LGPL-2.1-or-later
#pragma once

#include <whipple/exact/exact_factory.h>

namespace whipple::exact
{
  /// The one body of the scene.
  /// @throws InputError (one line, without file name) if there are more or none.
  const BodyState<2> &
  only_body(const ExactRequest<2> &request);

  /// A solid as the linear theory of elasticity sees it.
  struct ElasticConstants
  {
    double density       = 0; ///< g/cm^3
    double bulk_modulus  = 0; ///< rho c^2 of the state at rest, Mbar
    double shear_modulus = 0; ///< 0 without strength, Mbar

    /// Speed of longitudinal waves, cm/us.
    double
    wave_speed() const;
  };

  /// Of a body in the state in which it enters the scene.
  ElasticConstants
  elastic_constants(const BodyState<2> &body);

  /// A fluid at rest, about which a flow is given.
  struct UniformFluid
  {
    double density = 0; ///< g/cm^3
    double energy  = 0; ///< Mbar cm^3/g
  };

  /// From the constants "Density" and "Pressure" of the request.
  /// @throws InputError (one line, without file name) if the body's law has no such state.
  UniformFluid
  uniform_fluid(const ExactRequest<2> &request, const BodyState<2> &body);

  /// Those constants, as a kind declares them.
  extern const ExactConstant uniform_density, uniform_pressure;

  /// Of the one body of the scene, which must have strength.
  /// @throws InputError (one line, without file name) otherwise.
  ElasticConstants
  only_elastic_solid(const ExactRequest<2> &request);

  /// The one body of the scene, which must not have strength.
  /// @throws InputError (one line, without file name) otherwise.
  const BodyState<2> &
  only_fluid(const ExactRequest<2> &request);
} // namespace whipple::exact
