// SPDX-License-Identifier: LGPL-2.1-or-later
#include <whipple/error.h>
#include <whipple/exact/riemann.h>
#include <whipple/problem/effect_forecast.h>
#include <whipple/problem/inflow_check.h>
#include <whipple/problem/material_effects.h>
#include <whipple/problem/touches_side.h>
#include <whipple/scene/sections.h>

#include <algorithm>
#include <cmath>

namespace whipple::sections
{
  namespace
  {
    /// Part of the domain by which a body may miss a side that it touches.
    constexpr double touching = 1e-12;

    /// Speed of sound behind the wave that a plane wall drives into a body which it meets with this velocity (< 0: it
    /// recedes), as half of the impact of two such bodies; 0 if there is no such wave.
    template <int dim>
    double
    sound_behind_wall(const Problem<dim> &problem, const Body<dim> &body, double velocity)
    {
      const Material &material = problem.materials[body.material].model;
      const double    density  = body.density / (1. - initial_void_fraction(material)); // what crushed pores leave
      try
        {
          const exact::Riemann impact({material.eos, density, 2. * velocity, body.energy},
                                      {material.eos, density, 0., body.energy});
          const auto           behind = impact.on_ray(impact.velocity());
          return exact::fluid_point(*material.eos, behind.density, behind.energy).sound_speed;
        }
      catch (const StateError &)
        {
          return 0;
        }
    }
  } // namespace

  template <int dim>
  void
  check_inflow(SceneParameters &parameters, const Problem<dim> &problem)
  {
    const Scene<dim> &scene = problem.scene;
    const auto        fixed = std::find_if(scene.stages.begin(), scene.stages.end(),
                                           [](const Stage &stage) { return stage.mode() == StageMode::eulerian; });
    if (fixed == scene.stages.end())
      return;
    for (int side = 0; side < 2 * dim; ++side)
      for (const Body<dim> &body : scene.bodies)
        {
          const Boundary<dim> &boundary = scene.boundaries[side];
          if (boundary.kind != BoundaryKind::inflow || !body.is_uniform() || !touches_side(scene, body, side, touching))
            continue;
          const int    axis    = side / 2;
          const double inwards = (side % 2 == 0 ? 1. : -1.) * boundary.velocity[axis];
          const double closing = inwards - (side % 2 == 0 ? 1. : -1.) * body.velocity[axis];
          if (inwards <= 0 || std::abs(closing) <= touching * inwards) // what enters is what is there
            continue;
          const double sound = sound_behind_wall(problem, body, closing);
          if (sound > 0 && inwards >= sound)
            SceneSection(parameters, "Geometry")
                .reject(side_names[side],
                        "on the fixed mesh of stage '" + fixed->name + "' matter enters faster than sound, " +
                            rounded(sound) + " cm/us behind the wave in body '" + body.name +
                            "', so that nothing inside says what state it has; allowed are a slower inflow, a stage "
                            "with Mode = lagrangian (a piston), and a body of its own that flows in with the "
                            "side's velocity");
        }
  }

  template void
  check_inflow(SceneParameters &, const Problem<2> &);
} // namespace whipple::sections
