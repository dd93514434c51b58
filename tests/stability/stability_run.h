// SPDX-License-Identifier: LGPL-2.1-or-later
#pragma once

#include "case_record.h"
#include "scene_text.h"
#include "statistics_table.h"

#include <whipple/error.h>
#include <whipple/output/output_directory.h>
#include <whipple/scene/scene.h>
#include <whipple/stage/simulation.h>

#include <algorithm>
#include <filesystem>
#include <memory>
#include <optional>
#include <string>
#include <vector>

namespace whipple::stability
{
  /// One owned cell with material at the end of a run.
  struct Cell
  {
    double x[2];     ///< centre, cm
    double extent;   ///< along axis 1, cm
    double volume;   ///< cm^3
    double mass;     ///< of all materials, g
    double velocity; ///< along axis 1, mean of the corners, cm/us
    double density;  ///< mass / volume of the cell, g/cm^3
    double pressure; ///< volume-weighted over the materials, open void counting as 0, Mbar
    double energy;   ///< specific internal energy by mass, Mbar cm^3/g
  };

  /// A run that ended, or stopped.
  struct Outcome
  {
    std::unique_ptr<Simulation<2>> simulation;
    std::optional<std::string>     stopped; ///< why, if it did
    std::string                    directory;
    StatisticsTable                statistics;

    const FlatMesh<2> &
    mesh() const
    {
      return simulation->domain().view->mesh;
    }
    const State<2> &
    state() const
    {
      return simulation->domain().state;
    }

    /// Largest kinetic energy over what all bodies brought with them.
    double
    kinetic_growth() const
    {
      return largest("kinetic energy") / simulation->ledger().introduced().kinetic_energy;
    }

    double
    largest(const std::string &column) const
    {
      const auto &values = statistics[column];
      return *std::max_element(values.begin(), values.end());
    }

    /// Largest closure of mass, axial momentum and energy over all steps.
    double
    closure() const
    {
      return std::max({largest("mass closure"), largest("axial momentum closure"), largest("energy closure")});
    }

    /// Steps of all stages.
    long
    steps() const
    {
      long sum = 0;
      for (const summary::Stage &stage : simulation->summary().stages)
        sum += stage.steps;
      return sum;
    }

    /// Smallest time step over the median one; the last step of a stage, which ends where it must, is left out.
    double
    smallest_step_over_median() const
    {
      const auto         &stage = statistics["stage"], &dt = statistics["time step"];
      std::vector<double> steps;
      for (std::size_t i = 0; i + 1 < dt.size(); ++i)
        if (stage[i] == stage[i + 1])
          steps.push_back(dt[i]);
      if (steps.empty())
        return 1.;
      std::sort(steps.begin(), steps.end());
      return steps.front() / steps[steps.size() / 2];
    }

    /// Owned cells with material, ordered along axis 1.
    std::vector<Cell>
    cells() const
    {
      std::vector<Cell> result;
      for (Index c = 0; c < mesh().n_owned; ++c)
        {
          Cell   cell{{0, 0}, 0, state().volume[c], 0, 0, 0, 0, 0};
          double energy = 0;
          for (const MaterialState &m : state().material)
            {
              cell.mass += m.mass[c];
              energy += m.mass[c] * m.energy[c];
              cell.pressure += m.volume[c] * m.pressure[c] / cell.volume;
            }
          if (!(cell.mass > 0))
            continue;
          cell.energy  = energy / cell.mass;
          cell.density = cell.mass / cell.volume;
          for (int k = 0; k < 4; ++k)
            {
              const Index n = mesh().cell_node[4 * c + k];
              for (int d = 0; d < 2; ++d)
                cell.x[d] += 0.25 * state().position[d][n];
              cell.velocity += 0.25 * state().velocity[1][n];
              cell.extent += (k < 2 ? -0.5 : 0.5) * state().position[1][n];
            }
          result.push_back(cell);
        }
      std::sort(result.begin(), result.end(), [](const Cell &a, const Cell &b) { return a.x[1] < b.x[1]; });
      return result;
    }

    /// Smallest value of a member of MaterialState over all cells that hold the material.
    double
    smallest(std::vector<double> MaterialState::*member) const
    {
      double result = std::numeric_limits<double>::infinity();
      for (const MaterialState &m : state().material)
        for (Index c = 0; c < mesh().n_owned; ++c)
          if (m.mass[c] > 0)
            result = std::isnan((m.*member)[c]) ? -std::numeric_limits<double>::infinity()
                                                : std::min(result, (m.*member)[c]);
      return result;
    }

    /// Largest value of a member of MaterialState over all cells that hold the material.
    double
    greatest(std::vector<double> MaterialState::*member) const
    {
      double result = -std::numeric_limits<double>::infinity();
      for (const MaterialState &m : state().material)
        for (Index c = 0; c < mesh().n_owned; ++c)
          if (m.mass[c] > 0)
            result =
                std::isnan((m.*member)[c]) ? std::numeric_limits<double>::infinity() : std::max(result, (m.*member)[c]);
      return result;
    }

    /// Fastest node with mass, component along axis 1 (up or down), cm/us.
    double
    fastest_axial() const
    {
      double result = 0;
      for (Index n = 0; n < mesh().n_nodes; ++n)
        if (state().node_mass[n] > 0)
          result = std::max(result, std::abs(state().velocity[1][n]));
      return result;
    }
  };

  /// Run a scene file, in this process; what stops it is an outcome, not an error.
  /// @param folder of the output, under stability_output/ of the working directory
  inline Outcome
  run_file(const std::string &file, const std::string &folder, const std::vector<std::string> &overrides = {})
  {
    Outcome outcome;
    outcome.directory = "stability_output/" + folder + "/run";
    std::filesystem::create_directories("stability_output/" + folder);
    prepare_output_directory(outcome.directory, MPI_COMM_SELF);
    outcome.simulation =
        std::make_unique<Simulation<2>>(read_scene<2>(file, overrides), outcome.directory, false, MPI_COMM_SELF);
    try
      {
        outcome.simulation->run();
      }
    catch (const StateError &error)
      {
        outcome.stopped = error.what();
      }
    outcome.statistics = StatisticsTable(outcome.directory + "/statistics.csv");
    return outcome;
  }

  /// Run a scene that was built in code; it is left beside its output as scene.prm.
  inline Outcome
  run(const SceneText &scene, const std::string &folder)
  {
    std::filesystem::create_directories("stability_output/" + folder);
    const std::string file = "stability_output/" + folder + "/scene.prm";
    scene.write(file);
    return run_file(file, folder);
  }

  /// What must hold of every run: it ends, nothing is not a number, the ledger is closed.
  inline void
  expect_sound(Case &table, const Outcome &outcome)
  {
    table.holds("finishes", !outcome.stopped, outcome.stopped ? "stopped: " + outcome.stopped->substr(0, 120) : "yes");
    table.at_most("closure of mass, momentum, energy", outcome.closure(), 1e-12);
  }

  /// ... and, where no side does work and bodies bring no pressure with them, kinetic energy is never more than at
  /// first.
  inline void
  expect_sound_impact(Case &table, const Outcome &outcome)
  {
    expect_sound(table, outcome);
    table.at_most("largest kinetic energy / that of the bodies", outcome.kinetic_growth(), 1. + 1e-9);
  }
} // namespace whipple::stability
