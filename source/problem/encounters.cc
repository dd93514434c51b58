// SPDX-License-Identifier: LGPL-2.1-or-later
#include <whipple/error.h>
#include <whipple/exact/isentrope.h>
#include <whipple/exact/riemann.h>
#include <whipple/problem/effect_forecast.h>
#include <whipple/problem/material_effects.h>

#include <algorithm>
#include <cmath>
#include <limits>
#include <map>
#include <tuple>
#include <utility>

namespace whipple
{
  namespace
  {
    constexpr double infinity = std::numeric_limits<double>::infinity();

    /// Speed at which two bodies close in along the line of flight; <= 0: they do not meet.
    template <int dim>
    double
    closing_speed(const Body<dim> &a, const Body<dim> &b)
    {
      const Box<dim> box_a = extent(a.shape), box_b = extent(b.shape);
      const bool     a_first = box_a.lower[flight_axis<dim>] + box_a.upper[flight_axis<dim>] <
                           box_b.lower[flight_axis<dim>] + box_b.upper[flight_axis<dim>];
      const double relative = a.velocity[flight_axis<dim>] - b.velocity[flight_axis<dim>];
      return a_first ? relative : -relative;
    }

    template <int dim>
    double
    axial_length(const Body<dim> &body)
    {
      const Box<dim> box = extent(body.shape);
      return box.upper[flight_axis<dim>] - box.lower[flight_axis<dim>];
    }

    /// Energy that is left above the initial one when a shocked material has expanded to zero pressure.
    double
    residual_energy(const Material &material, const exact::FluidPoint &rest, double pressure)
    {
      const exact::ShockedState shocked = exact::shock_to_pressure(*material.eos, rest, pressure);
      const exact::Isentrope    release(material.eos, shocked.behind);
      // what boils on release keeps a pressure as far as the table goes
      const double end = std::max(release.end().fluid.pressure, 0.);
      return release.at_pressure(std::min(end, shocked.behind.pressure)).fluid.energy - rest.energy;
    }

    /// Yield stress of the undeformed material at rest; 0 without strength.
    double
    yield_stress(const Material &material, const exact::FluidPoint &rest)
    {
      if (!material.strength)
        return 0;
      const double pressure = 0, strain = 0, rate = 0;
      double       shear = 0, yield = 0;
      material.strength->evaluate({{&rest.density, 1}, {&rest.energy, 1}, {&pressure, 1}, {&strain, 1}, {&rate, 1}},
                                  {&shear, 1}, {&yield, 1});
      return yield;
    }

    /// What one material suffers from the pressure of first contact, which changes its velocity by `jump`.
    template <int dim>
    void
    add_body(const Body<dim> &body, const Problem<dim> &problem, double jump, Encounter &encounter)
    {
      const Material         &model = problem.materials[body.material].complete;
      const exact::FluidPoint rest  = exact::fluid_point(*model.eos, body.density, body.energy);
      if (const double yield = yield_stress(model, rest); yield > 0)
        encounter.stress = std::min(encounter.stress, encounter.pressure / yield);
      const double spall = problem.scene.materials[body.material].request.constant_or("Spall strength", 0.);
      if (model.void_law)
        encounter.tension = std::max(encounter.tension, spall > 0 ? encounter.pressure / spall : infinity);
      if (model.thermal)
        {
          const double residual    = residual_energy(model, rest, encounter.pressure);
          const auto   transitions = model.thermal->transitions();
          encounter.residual       = std::max(encounter.residual, residual / transitions.melt_onset);
          encounter.kinetic        = std::max(encounter.kinetic, 0.5 * jump * jump / transitions.melt_onset);
          encounter.vapour         = std::max(encounter.vapour, residual / transitions.vapour_onset);
        }
    }

    template <int dim>
    Encounter
    meet(const Problem<dim> &problem, const Body<dim> &a, const Body<dim> &b, double speed)
    {
      const auto is_gas = [&](const Body<dim> &body) {
        return problem.scene.materials[body.material].request.equation_of_state == "ideal gas";
      };
      const Material &of_a = problem.materials[a.material].complete, &of_b = problem.materials[b.material].complete;
      Encounter       encounter;
      encounter.stress    = infinity;
      encounter.of_solids = !is_gas(a) && !is_gas(b);
      try
        {
          for (const Material *material : {&of_a, &of_b})
            if (sections::initial_void_fraction(*material) > 0.)
              throw StateError("porous: the shock is not that of the solid");
          const exact::Riemann contact({of_a.eos, a.density, speed, a.energy}, {of_b.eos, b.density, 0., b.energy});
          encounter.pressure = contact.pressure();
          encounter.echo     = {{2. / (contact.fastest_left() + speed), 2. / contact.fastest_right()}};
          add_body(a, problem, speed - contact.velocity(), encounter);
          add_body(b, problem, contact.velocity(), encounter);
        }
      catch (const StateError &)
        {
          encounter.is_known = false;
        }
      return encounter;
    }

    /// Two bodies that close in.
    struct Pair
    {
      std::size_t a, b;
      double      speed; ///< cm/us, > 0
    };

    template <int dim, typename Visit>
    void
    for_closing_pairs(const Scene<dim> &scene, const Visit &visit)
    {
      for (std::size_t a = 0; a < scene.bodies.size(); ++a)
        for (std::size_t b = a + 1; b < scene.bodies.size(); ++b)
          if (const double speed = closing_speed(scene.bodies[a], scene.bodies[b]); speed > 0)
            visit(Pair{a, b, speed});
    }

    /// Solves each impact of two states once.
    template <int dim>
    class Impacts
    {
    public:
      explicit Impacts(const Problem<dim> &problem)
        : problem_(problem)
      {
        std::map<std::tuple<std::size_t, double, double>, std::size_t> number;
        for (const Body<dim> &body : problem.scene.bodies)
          state_.push_back(
              number.emplace(std::tuple(body.material, body.density, body.energy), number.size()).first->second);
      }

      /// Bodies of the same two states.
      std::pair<std::size_t, std::size_t>
      kind(const Pair &pair) const
      {
        return {state_[pair.a], state_[pair.b]};
      }

      Encounter
      of(const Pair &pair)
      {
        const Body<dim> &a = problem_.scene.bodies[pair.a], &b = problem_.scene.bodies[pair.b];
        const auto [known, is_new] = solved_.try_emplace({kind(pair), pair.speed});
        if (is_new)
          known->second = meet(problem_, a, b, pair.speed);
        Encounter encounter   = known->second;
        encounter.description = a.name + " on " + b.name + " at " + rounded(10. * pair.speed) + " km/s";
        // the pressure ends when the wave has come back from the nearer free face
        encounter.duration = std::min(axial_length(a) * encounter.echo[0], axial_length(b) * encounter.echo[1]);
        return encounter;
      }

    private:
      const Problem<dim>                                                         &problem_;
      std::vector<std::size_t>                                                    state_; ///< of each body
      std::map<std::pair<std::pair<std::size_t, std::size_t>, double>, Encounter> solved_;
    };

    void
    highest_first(std::vector<Encounter> &all)
    {
      std::stable_sort(all.begin(), all.end(),
                       [](const Encounter &a, const Encounter &b) { return a.pressure > b.pressure; });
    }
  } // namespace

  template <int dim>
  std::vector<Encounter>
  encounters(const Problem<dim> &problem)
  {
    Impacts<dim>           impacts(problem);
    std::vector<Encounter> all;
    for_closing_pairs(problem.scene, [&](const Pair &pair) { all.push_back(impacts.of(pair)); });
    highest_first(all);
    return all;
  }

  template <int dim>
  std::vector<Encounter>
  extreme_encounters(const Problem<dim> &problem)
  {
    Impacts<dim>                                                         impacts(problem);
    std::map<std::pair<std::size_t, std::size_t>, std::pair<Pair, Pair>> slowest_and_fastest;
    for_closing_pairs(problem.scene, [&](const Pair &pair) {
      auto &[slowest, fastest] = slowest_and_fastest.try_emplace(impacts.kind(pair), pair, pair).first->second;
      if (pair.speed < slowest.speed)
        slowest = pair;
      if (pair.speed > fastest.speed)
        fastest = pair;
    });
    std::vector<Encounter> extreme;
    for (const auto &[kind, pairs] : slowest_and_fastest)
      {
        extreme.push_back(impacts.of(pairs.second));
        if (pairs.first.speed < pairs.second.speed)
          extreme.push_back(impacts.of(pairs.first));
      }
    highest_first(extreme);
    return extreme;
  }

  template <int dim>
  double
  joined_duration(const Scene<dim> &scene)
  {
    double fastest = 0, front = -infinity, time = 0, joined = 0;
    for (const Body<dim> &body : scene.bodies)
      if (body.velocity[flight_axis<dim>] > fastest)
        {
          fastest = body.velocity[flight_axis<dim>];
          front   = extent(body.shape).upper[flight_axis<dim>];
        }
    for (const Stage &stage : scene.stages)
      {
        const double start = time;
        const double end   = stage.end->expected({start, front, fastest});
        if (std::isfinite(end))
          time = end;
        if (!stage.lagrangian || stage.lagrangian->cohesion != Cohesion::fragments)
          joined += time - start;
      }
    return joined;
  }

  template std::vector<Encounter>
  encounters(const Problem<2> &);
  template std::vector<Encounter>
  extreme_encounters(const Problem<2> &);
  template double
  joined_duration(const Scene<2> &);
} // namespace whipple
