// SPDX-License-Identifier: LGPL-2.1-or-later
#include <whipple/error.h>
#include <whipple/exact/gas_piston.h>
#include <whipple/exact/profile_request.h>
#include <whipple/exact/riemann.h>

namespace whipple::exact
{
  ExactKind
  gas_piston_kind()
  {
    return {"gas piston",
            "the side Bottom, 'inflow' with a velocity along axis 1, drives a shock into the one body, a fluid of any "
            "equation of state that touches it (J. Saltzman's problem)",
            {}};
  }

  std::unique_ptr<const ExactSolution<2>>
  make_gas_piston(const ExactRequest<2> &request)
  {
    const std::string where = "exact solution '" + request.name + "': ";
    if (request.geometry != Geometry::planar)
      throw InputError(where + "Geometry: must be planar");
    if (request.bodies.size() != 1)
      throw InputError(where + "the scene has " + std::to_string(request.bodies.size()) + " bodies: must have one");
    const BodyState<2> &body = request.bodies.front();
    const Boundary<2>  &side = request.boundaries[2];
    if (side.kind != BoundaryKind::inflow || body.lower[1] != request.lower[1])
      throw InputError(where + "Geometry/Bottom must be the piston, 'inflow' with a velocity, and body '" + body.name +
                       "' must touch it");
    try
      {
        return in_plane(
            request,
            std::make_unique<Riemann>(
                Riemann::State{body.material.eos, body.density, 2. * side.velocity[1] - body.velocity[1], body.energy},
                Riemann::State{body.material.eos, body.density, body.velocity[1], body.energy}, body.lower[1]));
      }
    catch (const StateError &error)
      {
        throw InputError(where + error.what());
      }
  }
} // namespace whipple::exact
