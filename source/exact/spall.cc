// SPDX-License-Identifier: LGPL-2.1-or-later
#include <whipple/error.h>
#include <whipple/exact/solid_request.h>
#include <whipple/exact/spall.h>

#include <algorithm>
#include <cmath>
#include <utility>

namespace whipple::exact
{
  Spall::Spall(const Constants &given_constants)
    : constants(given_constants)
  {
  }

  double
  Spall::initial_velocity(double plate_coordinate) const
  {
    // even about X = -h and X = H, so with period 2 (h + H)
    const double period = 2. * (constants.flyer + constants.target);
    const double place  = std::abs(std::remainder(plate_coordinate + constants.flyer, period));
    return place < constants.flyer ? constants.velocity : 0.;
  }

  double
  Spall::displacement(double plate_coordinate, double time) const
  {
    // (1/2c) times the integral of v0 over what sound has reached; v0 is periodic, a flyer on both sides of X = -h
    const double period = 2. * (constants.flyer + constants.target), reach = constants.wave_speed * time;
    const auto   integral = [&](double x) {
      const double from_face = x + constants.flyer, rest = std::remainder(from_face, period);
      const double whole = std::round((from_face - rest) / period);
      return constants.velocity * (2. * constants.flyer * whole + std::clamp(rest, -constants.flyer, constants.flyer));
    };
    return 0.5 * (integral(plate_coordinate + reach) - integral(plate_coordinate - reach)) / constants.wave_speed;
  }

  double
  Spall::stress(double plate_coordinate, double time) const
  {
    const double reach = constants.wave_speed * time;
    return 0.5 * constants.density * constants.wave_speed *
           (initial_velocity(plate_coordinate - reach) - initial_velocity(plate_coordinate + reach));
  }

  ProfileState
  Spall::at(double coordinate, double time) const
  {
    const double reach = constants.wave_speed * time;
    const double place = constants.direction * (coordinate - constants.interface - constants.rest * time);
    if (place < -constants.flyer + displacement(-constants.flyer, time) ||
        place > constants.target + displacement(constants.target, time))
      return {0., not_given, 0., not_given};
    const double velocity = 0.5 * (initial_velocity(place - reach) + initial_velocity(place + reach));
    const double modulus  = constants.density * constants.wave_speed * constants.wave_speed;
    const double strain   = stress(place, time) / modulus;
    return {constants.density * (1. + strain), constants.rest + constants.direction * velocity,
            constants.bulk_modulus * strain, not_given};
  }

  bool
  Spall::counts(double coordinate, double time) const
  {
    const double place = constants.direction * (coordinate - constants.interface - constants.rest * time);
    const double since = time - spall_time();
    return !spalls() || since < 0 || std::abs(place - spall_plane()) > constants.wave_speed * since;
  }

  std::vector<double>
  Spall::breaks(double time) const
  {
    // the jump of v0 and its images, moving both ways, as far as they lie in the plates
    const double        period = 2. * (constants.flyer + constants.target), reach = constants.wave_speed * time;
    std::vector<double> places;
    for (const double jump : {0., -2. * constants.flyer})
      for (const double sign : {-1., 1.})
        {
          const double place =
              std::remainder(jump + sign * reach - 0.5 * (constants.target - constants.flyer), period) +
              0.5 * (constants.target - constants.flyer);
          if (place > -constants.flyer && place < constants.target)
            places.push_back(constants.interface + constants.rest * time + constants.direction * place);
        }
    std::sort(places.begin(), places.end());
    return places;
  }

  bool
  Spall::spalls() const
  {
    return constants.strength < 0.5 * constants.density * constants.wave_speed * constants.velocity;
  }

  double
  Spall::spall_plane() const
  {
    return constants.target - constants.flyer;
  }

  double
  Spall::spall_time() const
  {
    return (constants.target + constants.flyer) / constants.wave_speed;
  }

  double
  Spall::pull_back() const
  {
    return spalls() ? 2. * constants.strength / (constants.density * constants.wave_speed) : constants.velocity;
  }

  ExactKind
  spall_kind()
  {
    return {
        "spall",
        "acoustic impact of two touching plates of one material along axis 1, the thinner the flyer, until the first "
        "tension above the spall strength parts the target",
        {}};
  }

  std::unique_ptr<const ExactSolution<2>>
  make_spall(const ExactRequest<2> &request)
  {
    const std::string what = "exact solution '" + request.name + "': ";
    if (request.bodies.size() != 2)
      throw InputError(what + "the scene has " + std::to_string(request.bodies.size()) + " bodies: must have two");
    const BodyState<2> *flyer = &request.bodies[0], *target = &request.bodies[1];
    if (flyer->upper[1] - flyer->lower[1] > target->upper[1] - target->lower[1])
      std::swap(flyer, target);
    const ElasticConstants elastic = elastic_constants(*target);
    if (flyer->material.name != target->material.name || flyer->density != target->density)
      throw InputError(what + "bodies '" + flyer->name + "' and '" + target->name + "' must be of one material");

    Spall::Constants constants;
    constants.density      = elastic.density;
    constants.bulk_modulus = elastic.bulk_modulus;
    constants.wave_speed   = elastic.wave_speed();
    constants.flyer        = flyer->upper[1] - flyer->lower[1];
    constants.target       = target->upper[1] - target->lower[1];
    constants.direction    = flyer->lower[1] < target->lower[1] ? 1. : -1.;
    constants.interface    = constants.direction > 0 ? target->lower[1] : target->upper[1];
    constants.rest         = target->velocity[1];
    constants.velocity     = constants.direction * (flyer->velocity[1] - target->velocity[1]);
    const double gap =
        constants.direction > 0 ? target->lower[1] - flyer->upper[1] : flyer->lower[1] - target->upper[1];
    if (std::abs(gap) > 1e-9 * constants.target)
      throw InputError(what + "bodies '" + flyer->name + "' and '" + target->name + "' must touch");
    if (!(constants.velocity > 0))
      throw InputError(what + "bodies '" + flyer->name + "' and '" + target->name + "' must approach each other");
    if (target->material.void_law)
      constants.strength = target->constants.constant_or("Spall strength", 0.) * elastic.density *
                           elastic.wave_speed() * elastic.wave_speed() / elastic.bulk_modulus;
    return std::make_unique<ProfileSolution<2>>(request.name, std::make_unique<Spall>(constants), Geometry::planar,
                                                request.symmetry, request.start);
  }
} // namespace whipple::exact
