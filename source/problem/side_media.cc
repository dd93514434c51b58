// SPDX-License-Identifier: LGPL-2.1-or-later
#include <whipple/problem/problem_sections.h>
#include <whipple/problem/touches_side.h>
#include <whipple/scene/sections.h>

#include <array>
#include <cmath>
#include <sstream>

namespace whipple::sections
{
  namespace
  {
    /// Distance from a side within which a body counts as touching it, and what media may differ in pressure and
    /// velocity by, relative to the domain, to rho c^2 and to c.
    constexpr double touching = 1e-9;

    /// Pressure and sound speed of a body as it enters.
    template <int dim>
    std::array<double, 2>
    pressure_and_sound(const Body<dim> &body, const Problem<dim> &problem)
    {
      const std::array<double, 1> density{body.density}, energy{body.energy};
      std::array<double, 1>       pressure{}, square{};
      problem.materials[body.material].model.eos->evaluate(density, energy, pressure, square);
      return {pressure[0], std::sqrt(std::max(square[0], 0.))};
    }

    /// The medium beyond one side: the bodies that touch it, which must agree in pressure and velocity.
    template <int dim>
    void
    read_medium(const SceneSection &section, int side, Problem<dim> &problem)
    {
      Scene<dim>      &scene    = problem.scene;
      Boundary<dim>   &boundary = scene.boundaries[side];
      const Body<dim> *first    = nullptr;
      boundary.medium.assign(scene.materials.size(), {});
      for (const Body<dim> &body : scene.bodies)
        {
          if (!touches_side(scene, body, side, touching))
            continue;
          if (!body.is_uniform() || body.deposit)
            section.reject(side_names[side], "body '" + body.name +
                                                 "' touches this side and is not uniform; allowed are bodies whose "
                                                 "pressure and velocity are the same everywhere");
          const auto [pressure, sound] = pressure_and_sound(body, problem);
          if (!first)
            {
              first             = &body;
              boundary.pressure = pressure;
              boundary.velocity = body.velocity;
            }
          bool same = std::abs(pressure - boundary.pressure) <= touching * body.density * sound * sound;
          for (int d = 0; d < dim; ++d)
            same = same && std::abs(body.velocity[d] - boundary.velocity[d]) <= touching * sound;
          if (!same)
            {
              std::ostringstream text;
              text << "bodies '" << first->name << "' and '" << body.name << "' touch this side at "
                   << boundary.pressure << " and " << pressure
                   << " Mbar or with different velocities; allowed is one ambient state a side";
              section.reject(side_names[side], text.str());
            }
          boundary.medium[body.material] = {body.density, body.energy};
        }
      if (!first)
        section.reject(side_names[side], "no body touches this side, so there is no ambient stress to keep; allowed is "
                                         "'transmitting'");
    }
  } // namespace

  template <int dim>
  void
  read_side_media(SceneParameters &parameters, Problem<dim> &problem)
  {
    const SceneSection section(parameters, "Geometry");
    for (int side = 0; side < 2 * dim; ++side)
      if (problem.scene.boundaries[side].keeps_ambient)
        read_medium(section, side, problem);
  }

  template void
  read_side_media(SceneParameters &, Problem<2> &);
} // namespace whipple::sections
