// SPDX-License-Identifier: LGPL-2.1-or-later
#include <whipple/error.h>
#include <whipple/exact/fluid_point.h>
#include <whipple/exact/profile_request.h>
#include <whipple/exact/rotation.h>
#include <whipple/exact/solid_request.h>

#include <utility>

namespace whipple::exact
{
  Rotation::Rotation(std::string name, const Constants &given_constants)
    : ExactSolution<2>(std::move(name))
    , constants(given_constants)
  {
  }

  PointState<2>
  Rotation::at(const Vector<2> &x, double) const
  {
    PointState<2>   state;
    const Vector<2> centre = constants.disc.centre();
    const double    turn   = constants.rim_velocity / constants.disc.radius();
    state.density          = 0.;
    state.pressure         = 0.;
    state.velocity         = {{-turn * (x[1] - centre[1]), turn * (x[0] - centre[0])}};
    if (!constants.disc.contains(x))
      return state;
    const double square = state.velocity[0] * state.velocity[0] + state.velocity[1] * state.velocity[1];
    state.density       = constants.density;
    state.pressure =
        constants.rim_pressure + 0.5 * constants.density * (square - constants.rim_velocity * constants.rim_velocity);
    state.energy = constants.eos->energy_of_pressure(constants.density, state.pressure);
    return state;
  }

  ExactKind
  rotation_kind()
  {
    return {
        "rotation",
        "disc of fluid (a solid without strength) that rotates rigidly, planar; the one body, whose pressure is that "
        "of the rim",
        {{"Rim velocity", "velocity", 0.01, "of the disc, anticlockwise"}}};
  }

  std::unique_ptr<const ExactSolution<2>>
  make_rotation(const ExactRequest<2> &request)
  {
    const std::string   what = "exact solution '" + request.name + "': ";
    const BodyState<2> &body = only_fluid(request);
    if (request.symmetry != Symmetry::planar || !body.round)
      throw InputError(what + "body '" + body.name + "' must be a sphere in planar symmetry");
    if (body.velocity != Vector<2>{})
      throw InputError(what + "body '" + body.name + "' must not have a velocity");
    Rotation::Constants constants;
    constants.eos          = body.material.eos;
    constants.disc         = outline(body);
    constants.density      = body.density;
    constants.rim_pressure = fluid_point(*body.material.eos, body.density, body.energy).pressure;
    constants.rim_velocity = constant(request, "Rim velocity");
    return std::make_unique<Rotation>(request.name, constants);
  }
} // namespace whipple::exact
