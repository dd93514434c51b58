// SPDX-License-Identifier: LGPL-2.1-or-later
#include <whipple/error.h>
#include <whipple/exact/isentropic_vortex.h>
#include <whipple/exact/profile_request.h>
#include <whipple/exact/solid_request.h>

#include <cmath>
#include <sstream>
#include <utility>

namespace whipple::exact
{
  IsentropicVortex::IsentropicVortex(std::string name, const Constants &given_constants)
    : ExactSolution<2>(std::move(name))
    , constants(given_constants)
  {
  }

  PointState<2>
  IsentropicVortex::at(const Vector<2> &x, double time) const
  {
    const double    since = constants.start + time, k = constants.exponent;
    const Vector<2> arm{{x[0] - constants.centre[0] - constants.drift[0] * since,
                         x[1] - constants.centre[1] - constants.drift[1] * since}};
    const double    decay = 1. - (arm[0] * arm[0] + arm[1] * arm[1]) / (constants.radius * constants.radius);
    const double    turn  = constants.speed / constants.radius * std::exp(0.5 * decay);
    const double    cold  = 1. - constants.speed * constants.speed * std::exp(decay) / (2. * k * constants.energy);

    PointState<2> state;
    state.density  = constants.density * std::pow(cold, 1. / (k - 1.));
    state.energy   = constants.energy * cold;
    state.pressure = (k - 1.) * state.density * state.energy;
    state.velocity = {{constants.drift[0] - turn * arm[1], constants.drift[1] + turn * arm[0]}};
    return state;
  }

  ExactKind
  isentropic_vortex_kind()
  {
    return {"isentropic vortex",
            "vortex in the one body of the scene, an ideal gas; planar",
            {uniform_density,
             uniform_pressure,
             {"Velocity along axis 0", "velocity", 0., "of the gas far away"},
             {"Velocity along axis 1", "velocity", 0., "of the gas far away"},
             {"Radius", "length", 1., "distance from the centre at which the gas turns fastest"},
             {"Speed", "velocity", 0.5, "of the gas there, about the centre"},
             {"Centre along axis 0", "length", 0., "of the vortex at time 0"},
             {"Centre along axis 1", "length", 0., "of the vortex at time 0"}}};
  }

  std::unique_ptr<const ExactSolution<2>>
  make_isentropic_vortex(const ExactRequest<2> &request)
  {
    if (request.symmetry != Symmetry::planar)
      throw InputError("exact solution '" + request.name + "': needs planar symmetry");
    const IdealGasState         gas   = only_gas(request);
    const UniformFluid          fluid = uniform_fluid(request, request.bodies.front());
    IsentropicVortex::Constants constants;
    constants.exponent = gas.exponent;
    constants.density  = fluid.density;
    constants.energy   = fluid.energy;
    constants.drift    = vector_constant(request, "Velocity");
    constants.centre   = vector_constant(request, "Centre");
    constants.radius   = positive_constant(request, "Radius");
    constants.speed    = positive_constant(request, "Speed");
    constants.start    = request.start;
    // the centre must not be colder than absolute zero
    const double limit = std::sqrt(2. * gas.exponent * fluid.energy / std::exp(1.));
    if (!(constants.speed < limit))
      {
        std::ostringstream message;
        message << "exact solution '" << request.name << "': Speed = " << constants.speed << " cm/us: must be below "
                << limit << " cm/us, where the gas at the centre has no energy left";
        throw InputError(message.str());
      }
    return std::make_unique<IsentropicVortex>(request.name, constants);
  }
} // namespace whipple::exact
