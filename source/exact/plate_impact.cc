// SPDX-License-Identifier: LGPL-2.1-or-later
#include <whipple/error.h>
#include <whipple/exact/plate_impact.h>

#include <algorithm>
#include <cmath>
#include <utility>

namespace whipple::exact
{
  namespace
  {
    const ProfileState vacuum{0., not_given, 0., not_given};

    /// Velocity at which both plates bear the same stress.
    double
    common_velocity(const PlateImpact::Plate &lower, const PlateImpact::Plate &upper)
    {
      double low = upper.velocity, high = lower.velocity;
      for (int i = 0; i < 100; ++i)
        {
          const double middle = 0.5 * (low + high);
          const bool   slow =
              lower.loading.stress(lower.velocity - middle) > upper.loading.stress(middle - upper.velocity);
          (slow ? low : high) = middle;
        }
      return 0.5 * (low + high);
    }
  } // namespace

  PlateImpact::PlateImpact(const Plate &lower, const Plate &upper)
  {
    const double closing = lower.velocity - upper.velocity;
    if (!(closing > 0))
      throw InputError("the plates do not approach each other");
    contact_time_       = std::max(0., upper.lower - lower.upper) / closing;
    contact_place_      = lower.upper + lower.velocity * contact_time_;
    interface_velocity_ = common_velocity(lower, upper);
    sides_              = {make_side(lower, -1.), make_side(upper, 1.)};
  }

  PlateImpact::Side
  PlateImpact::make_side(const Plate &plate, double direction) const
  {
    Side side;
    side.direction    = direction;
    side.velocity     = plate.velocity;
    side.rest         = plate.loading.initial();
    side.near         = direction > 0 ? plate.lower : plate.upper;
    side.far          = direction > 0 ? plate.upper : plate.lower;
    const double far  = side.far + plate.velocity * contact_time_;
    const double push = direction * (interface_velocity_ - plate.velocity);
    side.waves.emplace(plate.loading, Piston::Constants{contact_place_, direction, far, push, plate.velocity});

    // in the frame of the plate, outwards positive
    const auto &fronts = side.waves->fronts();
    side.arrival       = direction * (far - contact_place_) / fronts.front().speed;
    side.face          = far + plate.velocity * side.arrival;
    double inwards = plate.loading.wave_speed(side.rest), outwards = inwards;
    for (const WaveFront &front : fronts)
      {
        const double sound = plate.loading.wave_speed(front.behind);
        inwards            = std::max(inwards, sound - front.behind.velocity);
        outwards           = std::max(outwards, sound + front.behind.velocity);
      }
    side.inwards  = inwards - direction * plate.velocity;
    side.outwards = outwards + direction * plate.velocity;
    side.crossing = side.arrival + direction * (side.face - contact_place_ - interface_velocity_ * side.arrival) /
                                       (side.inwards + direction * interface_velocity_);
    if (!plate.loading.has_strength() && side.rest.pressure <= 0)
      {
        const LoadedState &shocked = fronts.back().behind;
        const FluidPoint   point   = fluid_point(*plate.eos, shocked.density, shocked.energy);
        Fan                fan;
        fan.isentrope              = std::make_shared<Isentrope>(plate.eos, point);
        fan.shocked                = shocked.velocity + direction * plate.velocity;
        const Isentrope::Point end = fan.isentrope->at_pressure(0.);
        fan.head                   = fan.shocked - point.sound_speed;
        fan.surface                = fan.shocked + end.speed;
        fan.tail                   = fan.surface - end.fluid.sound_speed;
        side.fan                   = fan;
      }
    return side;
  }

  ProfileState
  PlateImpact::in_side(const Side &side, double coordinate, double since) const
  {
    const double d = side.direction;
    if (since <= side.arrival)
      return d * (coordinate - side.face - side.velocity * (since - side.arrival)) > 0
                 ? vacuum
                 : side.waves->at(coordinate, since);
    const double speed = d * (coordinate - side.face) / (since - side.arrival);
    if (!side.fan)
      return speed > -side.inwards ? ProfileState{} : side.waves->at(coordinate, since);
    if (speed < side.fan->head)
      return side.waves->at(coordinate, since);
    if (speed > side.fan->surface)
      return vacuum;
    const Fan             &fan   = *side.fan;
    const Isentrope::Point point = fan.isentrope->at_ray(std::min(speed, fan.tail) - fan.shocked);
    return {point.fluid.density, d * (fan.shocked + point.speed), point.fluid.pressure, point.fluid.energy};
  }

  ProfileState
  PlateImpact::at(double coordinate, double time) const
  {
    const double since = time - contact_time_;
    if (since < 0)
      {
        for (const Side &side : sides_)
          {
            const double place = coordinate - side.velocity * time;
            if (side.direction * (place - side.near) >= 0 && side.direction * (place - side.far) <= 0)
              return {side.rest.density, side.velocity, side.rest.pressure, side.rest.energy};
          }
        return vacuum;
      }
    return in_side(sides_[coordinate > contact_place_ + interface_velocity_ * since], coordinate, since);
  }

  bool
  PlateImpact::counts(double coordinate, double time) const
  {
    const double since = time - contact_time_;
    const int    here  = coordinate > contact_place_ + interface_velocity_ * since;
    const Side  &side  = sides_[here];
    if (since > side.arrival && !side.fan &&
        side.direction * (coordinate - side.face) > -side.inwards * (since - side.arrival))
      return false;
    // a release that has reached the common face comes from there: the other plate's through it, its own reflected
    for (const Side &source : sides_)
      if (since > source.crossing)
        {
          const double from = contact_place_ + interface_velocity_ * source.crossing;
          if (side.direction * (coordinate - from) < side.outwards * (since - source.crossing))
            return false;
        }
    return true;
  }

  std::vector<double>
  PlateImpact::breaks(double time) const
  {
    const double since = time - contact_time_;
    if (since < 0)
      return {};
    std::vector<double> places{contact_place_ + interface_velocity_ * since};
    for (const Side &side : sides_)
      {
        if (since <= side.arrival)
          for (const double place : side.waves->breaks(since))
            places.push_back(place);
        else if (side.fan)
          for (const double speed : {side.fan->head, side.fan->tail})
            places.push_back(side.face + side.direction * speed * (since - side.arrival));
      }
    std::sort(places.begin(), places.end());
    return places;
  }

  std::optional<double>
  PlateImpact::shock_position(double time) const
  {
    const double since = time - contact_time_;
    const Side  &side  = sides_[1];
    if (since < 0 || since > side.arrival)
      return std::nullopt;
    return side.waves->shock_position(since);
  }

  ExactKind
  plate_impact_kind()
  {
    return {
        "plate impact",
        "two bodies, one above the other along axis 1, with or without strength, collide; without strength also the "
        "release of their rear faces",
        {}};
  }

  std::unique_ptr<const ExactSolution<2>>
  make_plate_impact(const ExactRequest<2> &request)
  {
    const std::string what = "exact solution '" + request.name + "': ";
    if (request.bodies.size() != 2)
      throw InputError(what + "the scene has " + std::to_string(request.bodies.size()) + " bodies: must have two");
    const BodyState<2> *lower = &request.bodies[0], *upper = &request.bodies[1];
    if (lower->lower[1] > upper->lower[1])
      std::swap(lower, upper);
    const auto plate = [](const BodyState<2> &body) {
      return PlateImpact::Plate{UniaxialLoading(body.material, body.density, body.energy), body.material.eos,
                                body.lower[1], body.upper[1], body.velocity[1]};
    };
    if (!(lower->velocity[1] > upper->velocity[1]))
      throw InputError(what + "bodies '" + lower->name + "' and '" + upper->name + "' must approach each other");
    return std::make_unique<ProfileSolution<2>>(request.name,
                                                std::make_unique<PlateImpact>(plate(*lower), plate(*upper)),
                                                Geometry::planar, request.symmetry, request.start);
  }
} // namespace whipple::exact
