// SPDX-License-Identifier: LGPL-2.1-or-later
#include <whipple/error.h>
#include <whipple/output/duration.h>
#include <whipple/output/first_rank.h>
#include <whipple/output/manifest.h>
#include <whipple/problem/effect_forecast.h>
#include <whipple/problem/scene_warnings.h>
#include <whipple/run/resume.h>
#include <whipple/scene/units.h>
#include <whipple/study/error_estimate.h>
#include <whipple/study/run.h>

#include <algorithm>
#include <iomanip>
#include <iostream>

namespace whipple
{
  namespace
  {
    /// A run from the start, or from where it was stopped.
    std::unique_ptr<Simulation<2>>
    make(const Problem<2> &problem, const RunOptions &options, const std::string &directory, double wall_start,
         MPI_Comm communicator)
    {
      const RunPlace place{directory, options.live, wall_start};
      const auto     earlier = options.overwrite ? EarlierRun::replaced : EarlierRun::refused;
      return options.resume ? go_on(problem, place, communicator) : start(problem, place, earlier, communicator);
    }

    /// Run the coarser scenes below DIR/error_estimate. One that stops is left out: two levels still give an error bar.
    std::vector<LevelResults>
    run_coarser(const std::vector<Problem<2>> &problems, const RunOptions &options, double wall_start,
                MPI_Comm communicator)
    {
      const bool                speaks = is_first_rank(communicator);
      std::vector<LevelResults> levels;
      for (const Problem<2> &problem : problems)
        {
          const std::string cell = units::format(problem.scene.lattice.spacing, units::length);
          const std::string name = "error_estimate/cell=" + cell.substr(0, cell.find(' ')) + "cm/";
          on_first_rank<Error>(communicator, [&] { manifest::note(options.output_directory, name); });
          if (speaks)
            std::cout << "error estimate: cells of " << cell << std::endl;
          const auto simulation =
              make(problem, options, options.output_directory + '/' + name, wall_start, communicator);
          try
            {
              simulation->run();
              levels.push_back({problem.scene.lattice.spacing, simulation->summary().results});
            }
          catch (const Interrupted &)
            {
              throw;
            }
          catch (const StateError &error)
            {
              if (speaks)
                std::cout << "error estimate: cells of " << cell << " left out, stopped: " << error.what() << std::endl;
            }
        }
      return levels;
    }
    /// Those that a run would begin with.
    void
    print_warnings(const Problem<2> &problem, MPI_Comm communicator)
    {
      if (is_first_rank(communicator))
        for (const std::string &line : scene_warnings(problem))
          std::cout << "warning: " << line << std::endl;
    }

    /// That the scene can be run, and what it is likely to take.
    void
    print_estimate(const Problem<2> &problem, MPI_Comm communicator)
    {
      if (!is_first_rank(communicator))
        return;
      const CostEstimate estimate = estimate_cost(problem);
      const std::size_t  stages   = problem.scene.stages.size();
      std::cout << problem.scene.file << ": fine. " << stages << (stages == 1 ? " stage" : " stages");
      if (estimate.steps > 0)
        std::cout << ", about " << rounded(estimate.steps) << " steps of at most " << rounded(estimate.cells)
                  << " cells: " << duration(estimate.seconds) << " of one core, " << rounded(1e-6 * estimate.bytes)
                  << " MB";
      std::cout << " (within a factor of 3";
      if (const auto open = std::ranges::count(estimate.stage_seconds, 0.); open > 0)
        std::cout << ", without " << open << (open == 1 ? " stage whose end" : " stages whose ends")
                  << " cannot be foreseen";
      std::cout << ')' << std::endl;
    }

    /// What the scene has, and what `auto` would choose for it.
    void
    print_effects(const Problem<2> &problem, MPI_Comm communicator)
    {
      if (!is_first_rank(communicator))
        return;
      constexpr std::size_t        most_bodies = 20; // of whose encounters a person reads the list
      const std::vector<Encounter> all =
          problem.scene.bodies.size() <= most_bodies ? encounters(problem) : extreme_encounters(problem);
      for (const Encounter &e : all)
        {
          std::cout << e.description;
          if (e.is_known)
            std::cout << std::setprecision(3) << ": " << 100. * e.pressure << " GPa for " << e.duration << " us\n";
          else
            std::cout << ": no one-dimensional shock solution\n";
        }
      std::cout << "the scene has (effect, whether, number, reason):\n";
      for (const EffectVerdict &verdict : problem.scene.effect_verdicts)
        std::cout << effect_line(verdict) << '\n';
      std::cout << "auto would choose:\n";
      for (const EffectVerdict &verdict : forecast_effects(problem))
        std::cout << effect_line(verdict) << '\n';
      std::cout << std::flush;
    }
  } // namespace

  void
  run_scene(const RunOptions &options, MPI_Comm communicator)
  {
    const Problem<2>              problem = read_problem<2>(options.scene_file, options.overrides);
    const std::vector<Problem<2>> coarser = coarser_problems(problem.scene, options.overrides);
    if (options.effects_report)
      print_effects(problem, communicator);
    if (options.validate_only)
      {
        print_warnings(problem, communicator);
        print_estimate(problem, communicator);
      }
    if (options.validate_only || options.effects_report)
      return;
    const double wall_start = MPI_Wtime();
    // the directory is judged, and cleared, before the coarser runs go into it
    const auto                simulation = make(problem, options, options.output_directory, wall_start, communicator);
    std::vector<LevelResults> levels     = run_coarser(coarser, options, wall_start, communicator);
    simulation->run();
    if (problem.scene.output.error_estimate_levels == 0)
      return;
    levels.push_back({problem.scene.lattice.spacing, simulation->summary().results});
    simulation->report_error_bars(error_bars(levels));
  }
} // namespace whipple
