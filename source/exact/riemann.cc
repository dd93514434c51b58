// SPDX-License-Identifier: LGPL-2.1-or-later
#include <whipple/error.h>
#include <whipple/exact/profile_request.h>
#include <whipple/exact/riemann.h>

#include <algorithm>
#include <cmath>

namespace whipple::exact
{
  Riemann::Riemann(const State &given_left, const State &given_right, double interface_position)
    : left(make_side(given_left, -1.))
    , right(make_side(given_right, 1.))
    , position(interface_position)
  {
    find_star();
    settle(this->left, -1.);
    settle(this->right, 1.);
  }

  Riemann::Side
  Riemann::make_side(const State &state, double outwards)
  {
    Side side;
    side.eos         = state.eos;
    side.undisturbed = fluid_point(*state.eos, state.density, state.energy);
    side.velocity    = outwards * state.velocity;
    if (side.undisturbed.sound_speed > 0)
      side.isentrope = std::make_unique<Isentrope>(state.eos, side.undisturbed);
    return side;
  }

  /// Velocity that the wave to a pressure gives the fluid, outwards: positive for a shock, negative for a rarefaction.
  double
  Riemann::recoil(const Side &side, double pressure)
  {
    if (pressure > side.undisturbed.pressure)
      return shock_to_pressure(*side.eos, side.undisturbed, pressure).velocity_jump;
    if (pressure == side.undisturbed.pressure)
      return 0.;
    return -side.isentrope->at_pressure(pressure).speed;
  }

  void
  Riemann::find_star()
  {
    // material flows off the contact to both sides at a rate that rises with the pressure; at p* it is zero
    const auto flow = [&](double pressure) {
      return left.velocity + recoil(left, pressure) + right.velocity + recoil(right, pressure);
    };
    double low = -std::numeric_limits<double>::infinity(), scale = 0, high = low;
    for (const Side *side : {&left, &right})
      {
        const FluidPoint &fluid = side->undisturbed;
        low                = std::max(low, side->isentrope ? side->isentrope->end().fluid.pressure : fluid.pressure);
        high               = std::max(high, fluid.pressure);
        const double speed = fluid.sound_speed + std::abs(left.velocity + right.velocity);
        scale              = std::max(scale, fluid.density * speed * speed);
      }
    if (flow(low) > 0)
      throw StateError("Riemann problem: the two fluids part and leave a vacuum between them (they would still flow "
                       "apart with " +
                       std::to_string(flow(low)) + " cm/us at a pressure of " + std::to_string(low) + " Mbar)");
    for (double rise = 1e-3 * scale; flow(high) < 0; rise *= 2)
      high += rise;
    for (int i = 0; i < 200; ++i)
      {
        const double middle             = 0.5 * (low + high);
        (flow(middle) < 0 ? low : high) = middle;
      }
    star_pressure = high;
    star_velocity = right.velocity + recoil(right, star_pressure);
  }

  void
  Riemann::settle(Side &side, double outwards) const
  {
    side.shocked = star_pressure > side.undisturbed.pressure;
    if (side.shocked)
      {
        const ShockedState shock = shock_to_pressure(*side.eos, side.undisturbed, star_pressure);
        side.star                = shock.behind;
        side.head = side.tail = side.velocity + shock.shock_speed;
        return;
      }
    side.star = side.undisturbed;
    if (side.isentrope && star_pressure < side.undisturbed.pressure)
      {
        side.star = side.isentrope->at_pressure(star_pressure).fluid;
        if (!side.isentrope->rises_until(star_pressure))
          throw StateError(side.eos->name() + ": the release to " + std::to_string(star_pressure) +
                           " Mbar is no simple rarefaction (a convex isentrope is needed)");
      }
    side.head = side.velocity + side.undisturbed.sound_speed;
    side.tail = outwards * star_velocity + side.star.sound_speed;
  }

  ProfileState
  Riemann::in_side(const Side &side, double ray) const
  {
    const double outwards = &side == &left ? -1. : 1.;
    const auto   state    = [](const FluidPoint &fluid, double velocity) {
      return ProfileState{fluid.density, velocity, fluid.pressure, fluid.energy};
    };
    if (outwards * ray >= side.head)
      return state(side.undisturbed, outwards * side.velocity);
    if (outwards * ray <= side.tail)
      return state(side.star, star_velocity);
    // ray = velocity - w + c outwards
    const Isentrope::Point point = side.isentrope->at_ray(side.velocity - outwards * ray);
    return state(point.fluid, outwards * (side.velocity - point.speed));
  }

  ProfileState
  Riemann::on_ray(double ray) const
  {
    return in_side(ray < star_velocity ? left : right, ray);
  }

  ProfileState
  Riemann::at(double coordinate, double time) const
  {
    const double distance = coordinate - position;
    if (time > 0)
      return on_ray(distance / time);
    const Side &side = distance < 0 ? left : right;
    return {side.undisturbed.density, (distance < 0 ? -1. : 1.) * side.velocity, side.undisturbed.pressure,
            side.undisturbed.energy};
  }

  std::vector<double>
  Riemann::breaks(double time) const
  {
    std::vector<double> result = {-left.head, -left.tail, star_velocity, right.tail, right.head};
    result.erase(std::unique(result.begin(), result.end()), result.end());
    for (double &ray : result)
      ray = position + ray * time;
    return result;
  }

  std::optional<double>
  Riemann::shock_position(double time) const
  {
    const double none_there = -std::numeric_limits<double>::infinity();
    const double to_left = left.shocked ? left.head : none_there, to_right = right.shocked ? right.head : none_there;
    if (!left.shocked && !right.shocked)
      return std::nullopt;
    return position + (to_right >= to_left ? to_right : -to_left) * time;
  }

  double
  Riemann::mean_density(double low, double high) const
  {
    const ProfileState a = on_ray(low), b = on_ray(high);
    return (b.density * (high - b.velocity) - a.density * (low - a.velocity)) / (high - low);
  }

  ExactKind
  riemann_kind()
  {
    return {"riemann",
            "two uniform fluids of any equation of state that meet at time 0: two bodies, one above the other, that "
            "touch (doc/theory/exact_gas.md)",
            {}};
  }

  namespace
  {
    /// @throws InputError if a signal reaches the outer end of a body before the run is over.
    void
    check_reach(const ExactRequest<2> &request, const BodyState<2> &body, double thickness, double signal)
    {
      const double arrival = signal > 0 ? thickness / signal : std::numeric_limits<double>::infinity();
      if (arrival < request.duration)
        throw InputError("exact solution '" + request.name + "': the wave in body '" + body.name +
                         "' reaches its far side at " + std::to_string(arrival) +
                         " us: the run must end before, not at " + std::to_string(request.duration) + " us");
    }
  } // namespace

  std::unique_ptr<const ExactSolution<2>>
  make_riemann(const ExactRequest<2> &request)
  {
    const std::string where = "exact solution '" + request.name + "': ";
    if (request.geometry != Geometry::planar)
      throw InputError(where + "Geometry: must be planar");
    if (request.bodies.size() != 2)
      throw InputError(where + "the scene has " + std::to_string(request.bodies.size()) +
                       " bodies: must have two, one above the other");
    const bool          ordered = request.bodies[0].lower[1] < request.bodies[1].lower[1];
    const BodyState<2> &low = request.bodies[ordered ? 0 : 1], &high = request.bodies[ordered ? 1 : 0];
    const double        interface_position = low.upper[1];
    if (std::abs(high.lower[1] - interface_position) > 1e-9 * (high.upper[1] - low.lower[1]))
      throw InputError(where + "body '" + low.name + "' ends at " + std::to_string(interface_position) + " cm and '" +
                       high.name + "' begins at " + std::to_string(high.lower[1]) + " cm: they must touch");
    const auto state = [](const BodyState<2> &body) {
      return Riemann::State{body.material.eos, body.density, body.velocity[1], body.energy};
    };
    try
      {
        auto solution = std::make_unique<Riemann>(state(low), state(high), interface_position);
        check_reach(request, low, interface_position - low.lower[1], solution->fastest_left() * -1. + low.velocity[1]);
        check_reach(request, high, high.upper[1] - interface_position, solution->fastest_right() - high.velocity[1]);
        return in_plane(request, std::move(solution));
      }
    catch (const StateError &error)
      {
        throw InputError(where + error.what());
      }
  }
} // namespace whipple::exact
