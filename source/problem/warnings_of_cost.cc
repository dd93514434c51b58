// SPDX-License-Identifier: LGPL-2.1-or-later
#include <whipple/output/duration.h>
#include <whipple/problem/effect_forecast.h>
#include <whipple/problem/scene_warnings.h>

#include <algorithm>
#include <cmath>

namespace whipple
{
  namespace
  {
    // Measured on the published chain (doc/performance.md): core seconds a cell step of each kind of stage, bytes a
    // cell of the largest stage above those of the program itself.
    constexpr double eulerian_seconds = 1.5e-6, lagrangian_seconds = 0.3e-6;
    constexpr double bytes_per_cell = 3.5e3, program_bytes = 1.7e8;

    /// Elements of debris over cells of what was thrown, and seconds a regrid, a file or a start may add are left out.
    constexpr double debris_growth = 3.;

    /// Area and edge of a body in the plane of computation, inside the domain: cm^2, cm.
    template <int dim>
    std::pair<double, double>
    area_and_edge(const Scene<dim> &scene, const Body<dim> &body)
    {
      const Box<dim>    box = extent(body.shape);
      const Vector<dim> low = scene.lattice.origin, high = scene.upper_corner();
      double            edge = 0;
      for (int d = 0; d < dim; ++d)
        edge += 2. * std::max(0., std::min(box.upper[d], high[d]) - std::max(box.lower[d], low[d]));
      return {body.shape->volume(Symmetry::planar, low, high), edge};
    }

    /// Largest signal speed that a body is likely to have: its sound speed and the largest velocity of the scene.
    template <int dim>
    double
    signal_speed(const Problem<dim> &problem)
    {
      double sound = 0, speed = 0;
      for (const Body<dim> &body : problem.scene.bodies)
        {
          double density[1]{body.density}, energy[1]{body.energy}, pressure[1]{}, sound_2[1]{}, square = 0;
          problem.materials[body.material].model.eos->evaluate(density, energy, pressure, sound_2);
          sound = std::max(sound, std::sqrt(std::max(sound_2[0], 0.)));
          for (const double v : body.velocity)
            square += v * v;
          speed = std::max(speed, std::sqrt(square));
        }
      return sound + speed;
    }
  } // namespace

  template <int dim>
  CostEstimate
  estimate_cost(const Problem<dim> &problem)
  {
    const Scene<dim>         &scene = problem.scene;
    const double              cell = scene.lattice.spacing, signal = signal_speed(problem);
    const std::vector<double> times = stage_times(scene);
    CostEstimate              result;
    double                    present = 0; // cells of what is in the scene
    double                    moving  = 0; // those of what has a velocity
    for (std::size_t s = 0; s < scene.stages.size(); ++s)
      {
        const Stage &stage    = scene.stages[s];
        const bool   eulerian = stage.mode() == StageMode::eulerian;
        if (s > 0 && !eulerian && scene.stages[s - 1].mode() == StageMode::eulerian)
          present = debris_growth * moving; // the rest is dropped
        for (const std::size_t b : stage.introduces)
          {
            const Body<dim> &body   = scene.bodies[b];
            const auto [area, edge] = area_and_edge(scene, body);
            present += area / (cell * cell) + (eulerian ? scene.mesh.buffer * edge / cell : 0.);
            moving += body.velocity != Vector<dim>{} ? area / (cell * cell) : 0.;
          }
        double most = 1; // cells of the domain
        for (int d = 0; d < dim; ++d)
          most *= scene.lattice.finest(d);
        const double cells = std::min(present, most);
        const double time  = times[s + 1] - times[s];
        const double dt    = std::min(scene.numerics.hydro.courant * cell / signal, stage.max_time_step);
        const double steps = std::isfinite(time) && signal > 0 ? time / dt : 0.;
        result.cells       = std::max(result.cells, cells);
        result.steps += steps;
        result.stage_seconds.push_back(steps * cells * (eulerian ? eulerian_seconds : lagrangian_seconds));
        result.seconds += result.stage_seconds.back();
      }
    result.bytes = program_bytes + bytes_per_cell * result.cells;
    return result;
  }

  namespace warnings
  {
    template <int dim>
    std::vector<std::string>
    cost(const Problem<dim> &problem)
    {
      constexpr double   much_memory = 1e9, much_time = 3600.;
      const CostEstimate estimate = estimate_cost(problem);
      const std::string  because  = " (" + rounded(estimate.cells) + " cells, " + rounded(estimate.steps) + " steps)";
      std::vector<std::string> lines;
      if (estimate.bytes > much_memory)
        lines.push_back("the run will take about " + rounded(estimate.bytes / 1e9) +
                        " GB of memory, all ranks together" + because);
      if (estimate.seconds > much_time)
        lines.push_back("the run will take about " + duration(estimate.seconds) + " of one core" + because);
      return lines;
    }

    template std::vector<std::string>
    cost(const Problem<2> &);
  } // namespace warnings

  template CostEstimate
  estimate_cost(const Problem<2> &);
} // namespace whipple
