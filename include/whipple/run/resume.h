// SPDX-License-Identifier: LGPL-2.1-or-later
#pragma once

#include <whipple/output/output_directory.h>
#include <whipple/run/simulation.h>

#include <memory>
#include <string>
#include <vector>

/// Runs from the start and from their checkpoints.
namespace whipple
{
  /// A run from its first stage on: the directory is prepared and parameters.prm written. Collective.
  /// @throws InputError if the directory cannot be used
  template <int dim>
  std::unique_ptr<Simulation<dim>>
  start(const Problem<dim> &problem, RunPlace place, EarlierRun earlier, MPI_Comm communicator);

  /// A run from the newest sound checkpoint in its directory, or from the start if it had not come to one. Checkpoints
  /// that are damaged are named in the log. Collective.
  /// @throws InputError if no checkpoint is sound, one is of another version, or the scene has changed in more than
  ///         what may change
  template <int dim>
  std::unique_ptr<Simulation<dim>>
  go_on(const Problem<dim> &problem, RunPlace place, MPI_Comm communicator);

  /// A parameter whose value in force is another than it was.
  struct ChangedParameter
  {
    std::string name; ///< "Stages/wall/End"
    std::string before, now;
  };

  /// Compare two texts of effective parameters (Scene::effective_parameters).
  std::vector<ChangedParameter>
  changed_parameters(const std::string &before, const std::string &now);

  /// Whether a run that goes on in a stage may do so with another value: what is written, and the ends of later stages.
  template <int dim>
  bool
  may_change(const std::string &name, const Scene<dim> &scene, std::size_t stage);
} // namespace whipple
