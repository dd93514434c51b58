// SPDX-License-Identifier: LGPL-2.1-or-later
#pragma once

#include "source_directory.h"

#include <whipple/output/output_directory.h>
#include <whipple/problem/problem.h>
#include <whipple/run/simulation.h>

#include <algorithm>
#include <filesystem>
#include <memory>
#include <string>
#include <vector>

namespace whipple::verification
{
  /// Run a scene of prm/ with overrides, all output into a folder under the working directory.
  inline std::unique_ptr<Simulation<2>>
  run(const std::string &scene, const std::vector<std::string> &overrides, const std::string &folder)
  {
    const std::string directory = "verification_output/" + folder;
    std::filesystem::create_directories("verification_output");
    prepare_output_directory(directory, EarlierRun::replaced, MPI_COMM_SELF);
    auto simulation = std::make_unique<Simulation<2>>(read_problem<2>(source_directory() + "/prm/" + scene, overrides),
                                                      RunPlace{directory}, MPI_COMM_SELF);
    simulation->run();
    return simulation;
  }

  /// One owned cell with material of a finished run.
  struct CellSample
  {
    double x[2];     ///< centre, cm
    double volume;   ///< cm^3
    double extent;   ///< along axis 1, cm
    double density;  ///< mass / volume of the cell, g/cm^3
    double velocity; ///< along axis 1, cm/us, mean of the corners
    double pressure; ///< of material 0, Mbar
    double stress;   ///< P - s_11 of material 0, Mbar
  };

  /// The owned cells with material, ordered along axis 1.
  inline std::vector<CellSample>
  samples(const Simulation<2> &simulation)
  {
    const FlatMesh<2>      &mesh     = simulation.domain().view->mesh;
    const State<2>         &state    = simulation.domain().state;
    const MaterialState    &m        = state.material[0];
    const auto             &pressure = simulation.domain().derived.material[0].pressure;
    std::vector<CellSample> result;
    for (Index c = 0; c < mesh.n_owned; ++c)
      if (m.mass[c] > 0)
        {
          CellSample s{{0, 0}, state.volume[c], 0, m.mass[c] / state.volume[c], 0, pressure[c], pressure[c]};
          if (state.index.stress[1] >= 0)
            s.stress -= m.fields[state.index.stress[1]].value[c];
          for (int k = 0; k < 4; ++k)
            {
              const Index n = mesh.cell_node[4 * c + k];
              s.x[0] += 0.25 * state.position[0][n];
              s.x[1] += 0.25 * state.position[1][n];
              s.velocity += 0.25 * state.velocity[1][n];
              s.extent += (k < 2 ? -0.5 : 0.5) * state.position[1][n];
            }
          result.push_back(s);
        }
    std::sort(result.begin(), result.end(), [](const CellSample &a, const CellSample &b) { return a.x[1] < b.x[1]; });
    return result;
  }

  /// Volume-weighted mean of a member over the cells with axis-1 centre in [low, high].
  inline double
  mean(const std::vector<CellSample> &cells, double CellSample::*member, double low, double high)
  {
    double sum = 0, volume = 0;
    for (const CellSample &s : cells)
      if (s.x[1] >= low && s.x[1] <= high)
        {
          sum += s.volume * (s.*member);
          volume += s.volume;
        }
    return sum / volume;
  }

  /// Where a member first falls through a level, walking up axis 1 from `from`; linear between cells.
  inline double
  falls_through(const std::vector<CellSample> &cells, double CellSample::*member, double level, double from)
  {
    for (std::size_t i = 1; i < cells.size(); ++i)
      {
        const CellSample &a = cells[i - 1], &b = cells[i];
        if (a.x[1] >= from && a.*member >= level && b.*member < level && b.x[1] > a.x[1])
          return a.x[1] + (a.*member - level) / (a.*member - b.*member) * (b.x[1] - a.x[1]);
      }
    return -1;
  }
} // namespace whipple::verification
