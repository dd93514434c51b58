// SPDX-License-Identifier: LGPL-2.1-or-later
#pragma once

#include <mpi.h>

#include <string>
#include <vector>

namespace whipple
{
  /// What the command line asks of a run.
  struct RunOptions
  {
    std::string              scene_file;             ///< the .prm
    std::vector<std::string> overrides;              ///< "Section/Sub/Name = value", later ones win
    std::string              output_directory;       ///< never empty: `output/<scene stem>` unless given
    bool                     overwrite      = false; ///< replace an earlier run in output_directory
    bool                     resume         = false; ///< go on with the run in output_directory
    bool                     validate_only  = false; ///< read and check the scene, compute and write nothing
    bool                     effects_report = false; ///< print which effects matter, compute and write nothing
    bool                     live           = false; ///< standard output is a terminal (RunLog refreshes in place)
  };

  /// Run a scene from its first stage to its last; if it asks for an error estimate, on coarser cells first
  /// (study/error_estimate.h). Collective; errors are thrown on every rank alike.
  /// @throws InputError before anything is computed if the scene or the output directory is not acceptable
  /// @throws StateError if the run cannot go on; the last good state and the summary are on disk then.
  void
  run_scene(const RunOptions &options, MPI_Comm communicator);
} // namespace whipple
