// SPDX-License-Identifier: LGPL-2.1-or-later
#include <whipple/problem/effect_forecast.h>
#include <whipple/problem/scene_warnings.h>

#include <algorithm>
#include <cmath>
#include <limits>
#include <optional>

namespace whipple::warnings
{
  namespace
  {
    constexpr double infinity = std::numeric_limits<double>::infinity();

    /// Debris of an impact at V spreads aside with about V / 4: of what the shield of 1993 throws, 95 % stay within a
    /// cone of 15 degrees half angle (0.15 of 0.57 cm/us), the edge flies at 0.23 V.
    constexpr double spreading = 0.25;

    const std::string side_names[]{"left", "right", "lower", "upper"};

    /// Whether something other than the bodies' own velocity may move matter: gas, energy, a side, an exact solution.
    template <int dim>
    bool
    is_driven(const Scene<dim> &scene, const std::vector<std::size_t> &bodies)
    {
      for (const Boundary<dim> &side : scene.boundaries)
        if (gives_velocity(side.kind) || (side.kind == BoundaryKind::pressure && side.pressure > 0))
          return true;
      return std::any_of(bodies.begin(), bodies.end(), [&](std::size_t b) {
        const Body<dim> &body = scene.bodies[b];
        return !body.is_uniform() || body.energy > 0 || body.deposit ||
               scene.materials[body.material].request.equation_of_state == "ideal gas";
      });
    }

    template <int dim>
    double
    fastest_upwards(const Scene<dim> &scene, const std::vector<std::size_t> &bodies)
    {
      double fastest = -infinity;
      for (const std::size_t b : bodies)
        fastest = std::max(fastest, scene.bodies[b].velocity[flight_axis<dim>]);
      return fastest;
    }

    std::string
    km_per_s(double velocity)
    {
      return rounded(10. * velocity) + " km/s";
    }

    /// Bodies that are in the scene when each stage has begun.
    template <int dim>
    std::vector<std::vector<std::size_t>>
    present_bodies(const Scene<dim> &scene)
    {
      std::vector<std::vector<std::size_t>> present;
      for (const Stage &stage : scene.stages)
        {
          present.push_back(present.empty() ? std::vector<std::size_t>{} : present.back());
          present.back().insert(present.back().end(), stage.introduces.begin(), stage.introduces.end());
        }
      return present;
    }
  } // namespace

  template <int dim>
  std::vector<std::string>
  endless_stages(const Scene<dim> &scene)
  {
    std::vector<std::string> lines;
    const auto               present = present_bodies(scene);
    for (std::size_t s = 0; s < scene.stages.size(); ++s)
      {
        const Stage &stage = scene.stages[s];
        if (is_driven(scene, present[s]))
          continue;
        const double fastest = fastest_upwards(scene, present[s]);
        if (const auto awaited = stage.end->awaited_body(); awaited && !(fastest > 0))
          lines.push_back("stage '" + stage.name + "' waits until something reaches body '" +
                          scene.bodies[*awaited].name + "', but of what is there nothing moves towards it (" +
                          km_per_s(fastest) + " at most): it cannot end");
        const bool   selects = s > 0 && stage.lagrangian && !scene.stages[s - 1].lagrangian;
        const double least   = selects ? stage.lagrangian->debris.minimum_axial_velocity : 0.;
        if (least > 0 && fastest < least)
          lines.push_back("stage '" + stage.name + "' drops what is slower than " + km_per_s(least) +
                          ", and the fastest body moves with " + km_per_s(fastest) + ": nothing will be left");
      }
    return lines;
  }

  namespace
  {
    template <int dim>
    bool
    overlaps_across(const Box<dim> &a, const Box<dim> &b, int axis)
    {
      for (int d = 0; d < dim; ++d)
        if (d != axis && !(a.lower[d] < b.upper[d] && b.lower[d] < a.upper[d]))
          return false;
      return true;
    }

    /// A meeting of a moving body with one ahead of it, along axis 1.
    struct Meeting
    {
      std::size_t target = 0;
      double      time   = infinity; ///< us
      double      speed  = 0;        ///< closing, cm/us
    };

    /// What a body meets on its way along the line of flight, first the first.
    template <int dim>
    std::vector<Meeting>
    meetings(const Scene<dim> &scene, std::size_t projectile, const std::vector<std::size_t> &entering)
    {
      const Body<dim>     &body = scene.bodies[projectile];
      const Box<dim>       own  = extent(body.shape);
      std::vector<Meeting> all;
      for (const std::size_t b : entering)
        {
          const Box<dim> box     = extent(scene.bodies[b].shape);
          const double   forward = body.velocity[flight_axis<dim>] > 0 ? 1. : -1.;
          const double   gap     = forward > 0 ? box.lower[flight_axis<dim>] - own.upper[flight_axis<dim>]
                                               : own.lower[flight_axis<dim>] - box.upper[flight_axis<dim>];
          const double speed = forward * (body.velocity[flight_axis<dim>] - scene.bodies[b].velocity[flight_axis<dim>]);
          if (b != projectile && speed > 0 && gap > -1e-9 * scene.lattice.spacing &&
              overlaps_across(own, box, flight_axis<dim>))
            all.push_back({b, std::max(gap, 0.) / speed, speed});
        }
      std::sort(all.begin(), all.end(), [](const Meeting &a, const Meeting &b) { return a.time < b.time; });
      return all;
    }

    template <int dim>
    bool
    is_open(const Scene<dim> &scene, int side)
    {
      const BoundaryKind kind = scene.boundaries[side].kind;
      return kind == BoundaryKind::transmitting || kind == BoundaryKind::pressure;
    }

    /// Distance from a box to a side; none if it touches the side from the start: then matter that flows through it is
    /// meant.
    template <int dim>
    std::optional<double>
    way_to_side(const Scene<dim> &scene, const Box<dim> &box, int side)
    {
      const int    axis = side / 2;
      const double way =
          side % 2 == 0 ? box.lower[axis] - scene.lattice.origin[axis] : scene.upper_corner()[axis] - box.upper[axis];
      return way > 1e-9 * scene.lattice.spacing ? std::optional<double>(way) : std::nullopt;
    }

    struct First
    {
      double      time = infinity; ///< us
      int         side = 0;
      std::string what;

      void
      take(double other_time, int other_side, const std::string &other)
      {
        if (other_time < time)
          {
            time = other_time;
            side = other_side;
            what = other;
          }
      }
    };

    std::string
    leaves(const std::string &what, int side, double time, double end)
    {
      return what + " reaches the " + side_names[side] + " side of the domain at about " + rounded(time) +
             " us and leaves; the last stage ends at " + rounded(end) + " us";
    }
  } // namespace

  template <int dim>
  std::vector<std::string>
  leaving_matter(const Scene<dim> &scene)
  {
    std::vector<std::string>       lines;
    const std::vector<std::size_t> entering = present_bodies(scene).back();
    const std::vector<double>      times    = stage_times(scene);
    const double                   end      = times.back();
    if (!std::isfinite(end) || scene.mesh_map != MeshMap::identity)
      return lines;
    First flight, debris; // one line each: the first to reach a side
    for (std::size_t s = 0; s < scene.stages.size(); ++s)
      for (const std::size_t b : scene.stages[s].introduces)
        {
          const Body<dim> &body = scene.bodies[b];
          const Box<dim>   box  = extent(body.shape);
          const auto       met =
              body.velocity[flight_axis<dim>] != 0. ? meetings(scene, b, entering) : std::vector<Meeting>{};
          for (int side = 0; side < 2 * dim; ++side)
            {
              const auto way = way_to_side(scene, box, side);
              if (!way || !is_open(scene, side))
                continue;
              const double outwards = (side % 2 == 0 ? -1. : 1.) * body.velocity[side / 2];
              const bool   stopped =
                  side / 2 == flight_axis<dim> && !met.empty(); // by what it meets, as far as anybody knows
              if (outwards > 0 && !stopped)
                flight.take(times[s] + *way / outwards, side, "body '" + body.name + "'");
              // debris that has gone through what is thinner than the projectile is long
              if (side / 2 == flight_axis<dim> || met.empty() || outwards > 0)
                continue;
              const Box<dim> target = extent(scene.bodies[met[0].target].shape);
              if (target.upper[flight_axis<dim>] - target.lower[flight_axis<dim>] >
                  box.upper[flight_axis<dim>] - box.lower[flight_axis<dim>])
                continue;
              debris.take(times[s] + met[0].time + *way / (spreading * met[0].speed), side,
                          "debris of body '" + body.name + "' on '" + scene.bodies[met[0].target].name + "'");
            }
        }
    for (const First &first : {flight, debris})
      if (first.time < end)
        lines.push_back(leaves(first.what, first.side, first.time, end));
    return lines;
  }

  template std::vector<std::string>
  endless_stages(const Scene<2> &);
  template std::vector<std::string>
  leaving_matter(const Scene<2> &);
} // namespace whipple::warnings
