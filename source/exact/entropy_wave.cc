// SPDX-License-Identifier: LGPL-2.1-or-later
#include <whipple/error.h>
#include <whipple/exact/entropy_wave.h>
#include <whipple/exact/fluid_point.h>
#include <whipple/exact/profile_request.h>
#include <whipple/exact/solid_request.h>

#include <cmath>
#include <sstream>
#include <utility>

namespace whipple::exact
{
  EntropyWave::EntropyWave(std::string name, const Constants &given_constants)
    : ExactSolution<2>(std::move(name))
    , constants(given_constants)
    , pressure_(fluid_point(*given_constants.eos, given_constants.density, given_constants.energy).pressure)
  {
  }

  PointState<2>
  EntropyWave::at(const Vector<2> &x, double time) const
  {
    const double since  = constants.start + time;
    double       square = 0;
    for (int d = 0; d < 2; ++d)
      square += std::pow(x[d] - constants.centre[d] - constants.velocity[d] * since, 2);
    PointState<2> state;
    state.density =
        constants.density * (1. + constants.amplitude * std::exp(-square / (constants.radius * constants.radius)));
    state.pressure = pressure_;
    state.energy   = constants.eos->energy_of_pressure(state.density, pressure_);
    state.velocity = constants.velocity;
    return state;
  }

  ExactKind
  entropy_wave_kind()
  {
    return {"entropy wave",
            "smooth spot of other density in uniform flow at uniform pressure; the one body, without strength",
            {uniform_density,
             uniform_pressure,
             {"Velocity along axis 0", "velocity", 0., "of the flow"},
             {"Velocity along axis 1", "velocity", 1., "of the flow"},
             {"Amplitude", "pure number", 0.2, "largest relative change of the density, above -1"},
             {"Radius", "length", 1., "of the spot: exp(-(distance / radius)^2)"},
             {"Centre along axis 0", "length", 0., "of the spot at time 0"},
             {"Centre along axis 1", "length", 0., "of the spot at time 0"}}};
  }

  std::unique_ptr<const ExactSolution<2>>
  make_entropy_wave(const ExactRequest<2> &request)
  {
    const BodyState<2>    &body  = only_fluid(request);
    const UniformFluid     fluid = uniform_fluid(request, body);
    EntropyWave::Constants constants;
    constants.eos       = body.material.eos;
    constants.density   = fluid.density;
    constants.energy    = fluid.energy;
    constants.velocity  = vector_constant(request, "Velocity");
    constants.centre    = vector_constant(request, "Centre");
    constants.radius    = positive_constant(request, "Radius");
    constants.amplitude = constant(request, "Amplitude");
    constants.start     = request.start;
    if (!(constants.amplitude > -1.))
      {
        std::ostringstream message;
        message << "exact solution '" << request.name << "': Amplitude = " << constants.amplitude << ": must be > -1";
        throw InputError(message.str());
      }
    if (request.symmetry == Symmetry::axisymmetric && (constants.centre[0] != 0. || constants.velocity[0] != 0.))
      throw InputError("exact solution '" + request.name +
                       "': in axisymmetry the centre must lie on the axis and the velocity along it");
    return std::make_unique<EntropyWave>(request.name, constants);
  }
} // namespace whipple::exact
