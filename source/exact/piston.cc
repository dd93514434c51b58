// SPDX-License-Identifier: LGPL-2.1-or-later
#include <whipple/error.h>
#include <whipple/exact/piston.h>
#include <whipple/exact/solid_request.h>

#include <algorithm>
#include <cmath>
#include <utility>

namespace whipple::exact
{
  Piston::Piston(const LoadedState &ahead, std::vector<WaveFront> fronts,
                 const std::function<double(const LoadedState &)> &wave_speed, const Constants &given_constants)
    : constants(given_constants)
    , ahead_(ahead)
    , fronts_(std::move(fronts))
    , arrival_(std::abs(constants.far_end - constants.origin) / fronts_.front().speed)
    , return_speed_(-wave_speed(ahead))
  {
    for (const WaveFront &front : fronts_)
      return_speed_ = std::min(return_speed_, front.behind.velocity - wave_speed(front.behind));
  }

  double
  Piston::place(double speed, double time) const
  {
    return constants.origin + (constants.direction * speed + constants.body_speed) * time;
  }

  ProfileState
  Piston::at(double coordinate, double time) const
  {
    const LoadedState *state = &ahead_;
    for (const WaveFront &front : fronts_)
      if (constants.direction * (coordinate - place(front.speed, time)) < 0)
        state = &front.behind;
    return {state->density, constants.body_speed + constants.direction * state->velocity, state->pressure,
            state->energy};
  }

  bool
  Piston::counts(double coordinate, double time) const
  {
    if (time <= arrival_)
      return true;
    const double limit = place(fronts_.front().speed, arrival_) +
                         (constants.direction * return_speed_ + constants.body_speed) * (time - arrival_);
    return constants.direction * (coordinate - limit) < 0;
  }

  std::vector<double>
  Piston::breaks(double time) const
  {
    std::vector<double> places;
    for (const WaveFront &front : fronts_)
      places.push_back(place(front.speed, time));
    std::sort(places.begin(), places.end());
    return places;
  }

  std::optional<double>
  Piston::shock_position(double time) const
  {
    return place(fronts_.back().speed, time);
  }

  Piston::Constants
  piston_of_scene(const ExactRequest<2> &request, const BodyState<2> &body)
  {
    const std::string what  = "exact solution '" + request.name + "': ";
    const bool        lower = request.boundaries[2].kind == BoundaryKind::inflow;
    if (lower == (request.boundaries[3].kind == BoundaryKind::inflow))
      throw InputError(what + "either Geometry/Bottom or Geometry/Top must be the piston, 'inflow' with a velocity");

    Piston::Constants constants;
    constants.direction  = lower ? 1. : -1.;
    constants.origin     = lower ? request.lower[1] : request.upper[1];
    constants.far_end    = lower ? body.upper[1] : body.lower[1];
    constants.body_speed = body.velocity[1];
    constants.velocity   = constants.direction * (request.boundaries[lower ? 2 : 3].velocity[1] - body.velocity[1]);
    const double gap     = (lower ? body.lower[1] : body.upper[1]) - constants.origin;
    if (std::abs(gap) > 1e-9 * (request.upper[1] - request.lower[1]))
      throw InputError(what + "body '" + body.name + "' must touch the piston");
    if (!(constants.velocity > 0))
      throw InputError(what + "the piston must move into body '" + body.name + "'");
    return constants;
  }

  ExactKind
  piston_kind()
  {
    return {"elastic-plastic piston",
            "a side of axis 1 with 'inflow' drives an elastic and a plastic front into the one body of the scene "
            "(hypoelastic; ep_piston of ExactPack)",
            {}};
  }

  std::unique_ptr<const ExactSolution<2>>
  make_piston(const ExactRequest<2> &request)
  {
    const BodyState<2>   &body = only_body(request);
    const UniaxialLoading loading(body.material, body.density, body.energy);
    return std::make_unique<ProfileSolution<2>>(request.name,
                                                std::make_unique<Piston>(loading, piston_of_scene(request, body)),
                                                Geometry::planar, request.symmetry, request.start);
  }
} // namespace whipple::exact
