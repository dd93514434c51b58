// SPDX-License-Identifier: LGPL-2.1-or-later
#include <whipple/error.h>
#include <whipple/exact/profile_request.h>

#include <algorithm>
#include <sstream>
#include <utility>

namespace whipple::exact
{
  int
  space_dimensions(const ExactRequest<2> &request)
  {
    switch (request.geometry)
      {
      case Geometry::planar:
        return 1;
      case Geometry::cylindrical:
        return 2;
      case Geometry::spherical:
        break;
      }
    if (request.symmetry != Symmetry::axisymmetric)
      throw InputError("exact solution '" + request.name +
                       "': a spherical profile needs an axisymmetric scene; planar symmetry allows planar | "
                       "cylindrical");
    return 3;
  }

  IdealGasState
  only_gas(const ExactRequest<2> &request)
  {
    if (request.bodies.size() != 1)
      throw InputError("exact solution '" + request.name + "': the scene has " + std::to_string(request.bodies.size()) +
                       " bodies: must have one, of an ideal gas");
    const BodyState<2> &body = request.bodies.front();
    if (body.constants.equation_of_state != "ideal gas")
      throw InputError("exact solution '" + request.name + "': body '" + body.name + "' is a '" +
                       body.constants.equation_of_state + "': must be an 'ideal gas'");
    return {body.constants.constants.at("Adiabatic exponent"), body.density, body.energy};
  }

  double
  constant(const ExactRequest<2> &request, const std::string &key)
  {
    const auto found = request.constants.find(key);
    if (found == request.constants.end())
      throw InputError("exact solution '" + request.name + "': constant '" + key + "' is missing");
    return found->second;
  }

  Vector<2>
  vector_constant(const ExactRequest<2> &request, const std::string &key)
  {
    return {{constant(request, key + " along axis 0"), constant(request, key + " along axis 1")}};
  }

  double
  positive_constant(const ExactRequest<2> &request, const std::string &key)
  {
    const double value = constant(request, key);
    if (!(value > 0))
      {
        std::ostringstream message;
        message << "exact solution '" << request.name << "': " << key << " = " << value << ": must be > 0";
        throw InputError(message.str());
      }
    return value;
  }

  double
  extent(const ExactRequest<2> &request)
  {
    const BodyState<2> &body = request.bodies.front();
    if (request.geometry == Geometry::planar)
      return body.upper[1];
    if (request.geometry == Geometry::cylindrical && request.symmetry == Symmetry::axisymmetric)
      return body.upper[0];
    double reach = std::min(body.upper[0], body.upper[1]);
    for (const double lower : body.lower)
      if (lower < 0)
        reach = std::min(reach, -lower);
    return reach;
  }

  std::unique_ptr<const ExactSolution<2>>
  in_plane(const ExactRequest<2> &request, std::unique_ptr<const Profile> profile)
  {
    return std::make_unique<ProfileSolution<2>>(request.name, std::move(profile), request.geometry, request.symmetry,
                                                request.start);
  }
} // namespace whipple::exact
