// SPDX-License-Identifier: LGPL-2.1-or-later
#include <whipple/material/johnson_cook_damage.h>
#include <whipple/problem/effect_forecast.h>
#include <whipple/problem/scene_warnings.h>
#include <whipple/scene/sphere_shape.h>
#include <whipple/scene/units.h>

#include <algorithm>
#include <cmath>
#include <limits>

namespace whipple
{
  template <int dim>
  std::vector<std::string>
  scene_warnings(const Problem<dim> &problem)
  {
    std::vector<std::string> all;
    for (const auto &kind : {warnings::resolution<dim>, warnings::endless_stages<dim>, warnings::leaving_matter<dim>})
      for (const std::string &line : kind(problem.scene))
        all.push_back(line);
    for (const auto &kind :
         {warnings::damage_without_ductility<dim>, warnings::pressure_in_vacuum<dim>, warnings::cost<dim>})
      for (const std::string &line : kind(problem))
        all.push_back(line);
    return all;
  }

  template <int dim>
  std::vector<double>
  stage_times(const Scene<dim> &scene)
  {
    double fastest = 0, front = -std::numeric_limits<double>::infinity();
    for (const Stage &stage : scene.stages)
      for (const std::size_t b : stage.introduces)
        if (const Body<dim> &body = scene.bodies[b]; body.velocity[flight_axis<dim>] > fastest)
          {
            fastest = body.velocity[flight_axis<dim>];
            front   = extent(body.shape).upper[flight_axis<dim>];
          }
    std::vector<double> times{0.};
    for (const Stage &stage : scene.stages)
      {
        times.push_back(stage.end->expected({times.back(), front, fastest}));
      }
    return times;
  }

  namespace warnings
  {
    namespace
    {
      /// Extent of a body along an axis as the mesh sees it: what touches a symmetry plane goes on behind it, what
      /// touches both sides of the domain goes on for ever.
      template <int dim>
      double
      thickness(const Scene<dim> &scene, const Body<dim> &body, int axis)
      {
        const Box<dim> box = extent(body.shape);
        const double   low = scene.lattice.origin[axis], high = scene.upper_corner()[axis];
        const double   slack       = 1e-9 * scene.lattice.spacing;
        const bool     touches_low = box.lower[axis] <= low + slack, touches_high = box.upper[axis] >= high - slack;
        if (touches_low && touches_high)
          return std::numeric_limits<double>::infinity();
        const double inside   = std::min(box.upper[axis], high) - std::max(box.lower[axis], low);
        const auto   mirrors  = [&](int side) { return scene.boundaries[side].kind == BoundaryKind::reflecting; };
        const bool   mirrored = (touches_low && mirrors(2 * axis)) || (touches_high && mirrors(2 * axis + 1));
        return mirrored ? 2. * inside : inside;
      }

      /// Sides of the domain behind which the scene goes on as its mirror image.
      template <int dim>
      std::vector<MirrorPlane>
      mirrors(const Scene<dim> &scene)
      {
        std::vector<MirrorPlane> planes;
        for (int side = 0; side < 2 * dim; ++side)
          if (scene.boundaries[side].kind == BoundaryKind::reflecting)
            planes.push_back({side / 2, side % 2 ? scene.upper_corner()[side / 2] : scene.lattice.origin[side / 2]});
        return planes;
      }

      /// The smallest of those below a bound, and how many there are.
      struct Worst
      {
        std::string name;
        double      length = std::numeric_limits<double>::infinity();
        int         number = 0;

        void
        add(const std::string &body, double body_length, double bound)
        {
          if (!(body_length < bound))
            return;
          ++number;
          if (body_length < length)
            {
              name   = body;
              length = body_length;
            }
        }
        std::string
        subject() const
        {
          return "body '" + name + "'" + (number > 1 ? " (the worst of " + std::to_string(number) + " such)" : "");
        }
      };
    } // namespace

    template <int dim>
    std::vector<std::string>
    resolution(const Scene<dim> &scene)
    {
      constexpr double least_cells = 2.5, least_sphere_cells = 10., round_off = 1e-9;
      const double     cell  = scene.lattice.spacing;
      const auto       cells = [&](double length) {
        return rounded(length / cell) + " finest cells of " + units::format(cell, units::length);
      };
      std::vector<std::string> lines;
      if (scene.mesh_map != MeshMap::identity) // lengths on the lattice are not lengths in space
        return lines;
      Worst thin, coarse; // one line for all bodies of a kind
      for (const Body<dim> &body : scene.bodies)
        if (const auto *sphere = body.shape.template as<Sphere<dim>>())
          coarse.add(body.name, sphere->diameter, (1. - round_off) * least_sphere_cells * cell);
        else if (!body.shape->is_box())
          thin.add(body.name, body.shape->least_thickness(mirrors(scene)), (1. - round_off) * least_cells * cell);
        else
          {
            double thinnest = std::numeric_limits<double>::infinity();
            for (int d = 0; d < dim; ++d)
              thinnest = std::min(thinnest, thickness(scene, body, d));
            thin.add(body.name, thinnest, (1. - round_off) * least_cells * cell);
          }
      if (thin.number > 0)
        lines.push_back(thin.subject() + " is " + units::format(thin.length, units::length) + " thin, " +
                        cells(thin.length) + ": with fewer than 2.5 the mesh does not know where in a cell it is");
      if (coarse.number > 0)
        lines.push_back(coarse.subject() + " has a diameter of " + units::format(coarse.length, units::length) + ", " +
                        cells(coarse.length) + ": with fewer than 10 its shape and its shock are coarse");
      return lines;
    }

    template <int dim>
    std::vector<std::string>
    damage_without_ductility(const Problem<dim> &problem)
    {
      std::vector<std::string> lines;
      for (std::size_t m = 0; m < problem.materials.size(); ++m)
        if (const auto *damage = dynamic_cast<const JohnsonCookDamage *>(problem.materials[m].model.failure.get()))
          if (const auto triaxiality = damage->end_of_ductility())
            lines.push_back("material '" + problem.scene.materials[m].name +
                            "': the fit of its Johnson-Cook damage has no ductility left where tension is above " +
                            rounded(*triaxiality) + " times the equivalent stress; beyond " +
                            rounded(damage->largest_triaxiality()) + " the strain at failure stays what it is there");
      return lines;
    }

    template <int dim>
    std::vector<std::string>
    pressure_in_vacuum(const Problem<dim> &problem)
    {
      // what an impact of like bodies turns into heat at most; a gas with Gamma = 3 is stiffer than any that is known
      constexpr double thin = 1e-3, stiffest = 3.;
      double           fastest = 0;
      for (const Body<dim> &a : problem.scene.bodies)
        for (const Body<dim> &b : problem.scene.bodies)
          {
            double square = 0;
            for (int d = 0; d < dim; ++d)
              square += (a.velocity[d] - b.velocity[d]) * (a.velocity[d] - b.velocity[d]);
            fastest = std::max(fastest, std::sqrt(square));
          }
      const double             energy = fastest * fastest / 8.;
      std::vector<std::string> lines;
      for (std::size_t m = 0; m < problem.materials.size(); ++m)
        {
          const EquationOfState &eos      = *problem.materials[m].model.eos;
          const double           density  = thin * eos.reference_density();
          double                 pressure = 0, sound_speed_squared = 0;
          eos.evaluate({&density, 1}, {&energy, 1}, {&pressure, 1}, {&sound_speed_squared, 1});
          if (pressure > stiffest * density * energy)
            lines.push_back("material '" + problem.scene.materials[m].name + "': its law '" + eos.name() + "' keeps " +
                            rounded(pressure) + " Mbar at a thousandth of its density with " + rounded(energy) +
                            " Mbar cm^3/g" + ", which an impact at " + rounded(10. * fastest) +
                            " km/s can bring: no void relieves that, and steps get short. Another equation of state "
                            "is meant for hot expanded matter");
        }
      return lines;
    }

    template std::vector<std::string>
    resolution(const Scene<2> &);
    template std::vector<std::string>
    pressure_in_vacuum(const Problem<2> &);
    template std::vector<std::string>
    damage_without_ductility(const Problem<2> &);
  } // namespace warnings

  template std::vector<std::string>
  scene_warnings(const Problem<2> &);
  template std::vector<double>
  stage_times(const Scene<2> &);
} // namespace whipple
