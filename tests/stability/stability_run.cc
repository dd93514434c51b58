// SPDX-License-Identifier: LGPL-2.1-or-later
#include "stability_run.h"

#include <whipple/error.h>
#include <whipple/output/output_directory.h>
#include <whipple/problem/problem.h>
#include <whipple/run/simulation.h>

#include <algorithm>
#include <cmath>
#include <filesystem>
#include <limits>
#include <tuple>

namespace whipple::stability
{
  const FlatMesh<2> &
  Outcome::mesh() const
  {
    return simulation->domain().view->mesh;
  }
  const State<2> &
  Outcome::state() const
  {
    return simulation->domain().state;
  }
  const Derived &
  Outcome::derived() const
  {
    return simulation->domain().derived;
  }
  const Ledger<2> &
  Outcome::ledger() const
  {
    return simulation->ledger();
  }
  const summary::Summary &
  Outcome::summary() const
  {
    return simulation->summary();
  }

  double
  Outcome::kinetic_growth() const
  {
    return largest("kinetic energy") / ledger().introduced().kinetic_energy;
  }

  double
  Outcome::largest(const std::string &column) const
  {
    if (summary().stages.empty() || steps() == 0)
      return std::numeric_limits<double>::quiet_NaN(); // stopped before its first step
    double result = -std::numeric_limits<double>::infinity();
    for (const double value : statistics[column])
      result = std::isnan(value) ? std::numeric_limits<double>::infinity() : std::max(result, value);
    return result;
  }

  double
  Outcome::closure() const
  {
    return std::max({largest("mass closure"), largest("axial momentum closure"), largest("energy closure")});
  }

  long
  Outcome::steps() const
  {
    long sum = 0;
    for (const summary::Stage &stage : summary().stages)
      sum += stage.steps;
    return sum;
  }

  double
  Outcome::smallest_step_over_median() const
  {
    if (steps() == 0)
      return std::numeric_limits<double>::quiet_NaN();
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

  std::vector<Cell>
  Outcome::cells() const
  {
    std::vector<Cell> result;
    for (Index c = 0; c < mesh().n_owned; ++c)
      {
        Cell   cell{{0, 0}, 0, state().volume[c], 0, 0, 0, 0, 0};
        double energy = 0;
        for (std::size_t i = 0; i < state().material.size(); ++i)
          {
            const MaterialState &m = state().material[i];
            cell.mass += m.mass[c];
            energy += m.mass[c] * m.energy[c];
            cell.pressure += m.volume[c] * derived().material[i].pressure[c] / cell.volume;
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
    std::sort(result.begin(), result.end(),
              [](const Cell &a, const Cell &b) { return std::tie(a.x[1], a.x[0]) < std::tie(b.x[1], b.x[0]); });
    return result;
  }

  double
  Outcome::smallest(std::vector<double> MaterialState::*member) const
  {
    double result = std::numeric_limits<double>::infinity();
    for (const MaterialState &m : state().material)
      for (Index c = 0; c < mesh().n_owned; ++c)
        if (m.mass[c] > 0)
          result =
              std::isnan((m.*member)[c]) ? -std::numeric_limits<double>::infinity() : std::min(result, (m.*member)[c]);
    return result;
  }

  double
  Outcome::smallest_pressure() const
  {
    double result = std::numeric_limits<double>::infinity();
    for (std::size_t m = 0; m < state().material.size(); ++m)
      for (Index c = 0; c < mesh().n_owned; ++c)
        if (state().material[m].mass[c] > 0)
          {
            const double pressure = derived().material[m].pressure[c];
            result = std::isnan(pressure) ? -std::numeric_limits<double>::infinity() : std::min(result, pressure);
          }
    return result;
  }

  double
  Outcome::greatest(std::vector<double> MaterialState::*member) const
  {
    double result = -std::numeric_limits<double>::infinity();
    for (const MaterialState &m : state().material)
      for (Index c = 0; c < mesh().n_owned; ++c)
        if (m.mass[c] > 0)
          result =
              std::isnan((m.*member)[c]) ? std::numeric_limits<double>::infinity() : std::max(result, (m.*member)[c]);
    return result;
  }

  double
  Outcome::fastest(int axis) const
  {
    double result = 0;
    for (Index n = 0; n < mesh().n_nodes; ++n)
      if (state().node_mass[n] > 0)
        result = std::max(result, std::abs(state().velocity[axis][n]));
    return result;
  }

  Outcome
  run_file(const std::string &file, const std::string &folder, const std::vector<std::string> &overrides)
  {
    Outcome outcome;
    outcome.directory = "stability_output/" + folder + "/run";
    std::filesystem::create_directories("stability_output/" + folder);
    prepare_output_directory(outcome.directory, EarlierRun::replaced, MPI_COMM_SELF);
    outcome.simulation =
        std::make_shared<Simulation<2>>(read_problem<2>(file, overrides), RunPlace{outcome.directory}, MPI_COMM_SELF);
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

  Outcome
  run(const SceneText &scene, const std::string &folder)
  {
    std::filesystem::create_directories("stability_output/" + folder);
    const std::string file = "stability_output/" + folder + "/scene.prm";
    scene.write(file);
    return run_file(file, folder);
  }

  void
  expect_sound(Case &table, const Outcome &outcome)
  {
    table.holds("finishes", !outcome.stopped, outcome.stopped ? "stopped: " + outcome.stopped->substr(0, 120) : "yes");
    table.at_most("closure of mass, momentum, energy", outcome.closure(), 1e-12);
  }

  void
  expect_sound_impact(Case &table, const Outcome &outcome)
  {
    expect_sound(table, outcome);
    table.at_most("largest kinetic energy / that of the bodies, less 1", outcome.kinetic_growth() - 1., 1e-9);
  }
} // namespace whipple::stability
