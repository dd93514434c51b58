// SPDX-License-Identifier: LGPL-2.1-or-later
#pragma once

#include <span>
#include <string>

/// Starting the ranks of a run, so that `whipple run SCENE -n 2` needs no mpirun around it.
namespace whipple::mpirun
{
  /// This process was started by mpirun (or another MPI launcher).
  bool
  is_rank();

  /// Run `mpirun -n ranks <this program> arguments` and wait for it. Allows root and more ranks than cores, and
  /// silences what Open MPI says about machines without fast networks; settings the environment already has win.
  /// Signals are passed on such that the ranks have time to stop with a checkpoint (run/interruption.h). Call before
  /// MPI is initialised.
  /// @returns exit status of the ranks; 128 and the signal's number if one has ended mpirun
  /// @throws Error if there is no mpirun.
  int
  run(int ranks, std::span<const std::string> arguments);

  /// Whether what this process prints ends on a terminal: the launcher's word for ranks of run(), whose own
  /// standard output is a pipe or pseudo-terminal of mpirun; else what isatty says.
  bool
  prints_to_terminal();
} // namespace whipple::mpirun
