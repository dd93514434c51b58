// SPDX-License-Identifier: LGPL-2.1-or-later
#include <whipple/error.h>
#include <whipple/run/resume.h>
#include <whipple/scene/effect_forecast.h>
#include <whipple/scene/scene_warnings.h>
#include <whipple/scene/units.h>
#include <whipple/study/error_estimate.h>
#include <whipple/study/run.h>

#include <iomanip>
#include <iostream>

namespace whipple
{
  namespace
  {
    /// A run from the start, or from where it was stopped.
    std::unique_ptr<Simulation<2>>
    make(const Scene<2> &scene, const RunOptions &options, const std::string &directory, double wall_start,
         MPI_Comm communicator)
    {
      const RunPlace place{directory, options.live, wall_start};
      return options.resume ? go_on(scene, place, communicator) : start(scene, place, communicator);
    }

    /// Run the coarser scenes below DIR/error_estimate. One that stops is left out: two levels still give an error bar.
    std::vector<LevelResults>
    run_coarser(const std::vector<Scene<2>> &scenes, const RunOptions &options, double wall_start,
                MPI_Comm communicator)
    {
      int rank = 0;
      MPI_Comm_rank(communicator, &rank);
      std::vector<LevelResults> levels;
      for (const Scene<2> &scene : scenes)
        {
          const std::string cell = units::format(scene.lattice.spacing, units::length);
          const std::string directory =
              options.output_directory + "/error_estimate/cell=" + cell.substr(0, cell.find(' ')) + "cm";
          if (rank == 0)
            std::cout << "error estimate: cells of " << cell << std::endl;
          const auto simulation = make(scene, options, directory, wall_start, communicator);
          try
            {
              simulation->run();
              levels.push_back({scene.lattice.spacing, simulation->summary().results});
            }
          catch (const Interrupted &)
            {
              throw;
            }
          catch (const StateError &error)
            {
              if (rank == 0)
                std::cout << "error estimate: cells of " << cell << " left out, stopped: " << error.what() << std::endl;
            }
        }
      return levels;
    }
    /// Those that a run would begin with.
    void
    print_warnings(const Scene<2> &scene, MPI_Comm communicator)
    {
      int rank = 0;
      MPI_Comm_rank(communicator, &rank);
      if (rank == 0)
        for (const std::string &line : scene_warnings(scene))
          std::cout << "warning: " << line << std::endl;
    }

    /// What the scene has, and what `auto` would choose for it.
    void
    print_effects(const Scene<2> &scene, MPI_Comm communicator)
    {
      int rank = 0;
      MPI_Comm_rank(communicator, &rank);
      if (rank != 0)
        return;
      constexpr std::size_t        most_bodies = 20; // of whose encounters a person reads the list
      const std::vector<Encounter> all =
          scene.bodies.size() <= most_bodies ? encounters(scene) : extreme_encounters(scene);
      for (const Encounter &e : all)
        {
          std::cout << e.description;
          if (e.is_known)
            std::cout << std::setprecision(3) << ": " << 100. * e.pressure << " GPa for " << e.duration << " us\n";
          else
            std::cout << ": no one-dimensional shock solution\n";
        }
      std::cout << "the scene has (effect, whether, number, reason):\n";
      for (const EffectVerdict &verdict : scene.effect_verdicts)
        std::cout << effect_line(verdict) << '\n';
      std::cout << "auto would choose:\n";
      for (const EffectVerdict &verdict : forecast_effects(scene))
        std::cout << effect_line(verdict) << '\n';
      std::cout << std::flush;
    }
  } // namespace

  void
  run_scene(const RunOptions &options, MPI_Comm communicator)
  {
    const Scene<2>              scene   = read_scene<2>(options.scene_file, options.overrides);
    const std::vector<Scene<2>> coarser = coarser_scenes(scene, options.overrides);
    if (options.effects_report)
      print_effects(scene, communicator);
    if (options.validate_only)
      print_warnings(scene, communicator);
    if (options.validate_only || options.effects_report)
      return;
    const double wall_start = MPI_Wtime();
    // the directory is judged, and cleared, before the coarser runs go into it
    const auto                simulation = make(scene, options, options.output_directory, wall_start, communicator);
    std::vector<LevelResults> levels     = run_coarser(coarser, options, wall_start, communicator);
    simulation->run();
    if (scene.output.error_estimate_levels == 0)
      return;
    levels.push_back({scene.lattice.spacing, simulation->summary().results});
    simulation->report_error_bars(error_bars(levels));
  }
} // namespace whipple
