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

  /// Become `mpirun -n ranks <this program> arguments`. Allows root and more ranks than cores, and silences
  /// what Open MPI says about machines without fast networks; settings the environment already has win.
  /// Call before MPI is initialised. Returns only by throwing.
  /// @throws Error if there is no mpirun.
  [[noreturn]] void
  become(int ranks, std::span<const std::string> arguments);

  /// Whether what this process prints ends on a terminal: the launcher's word for ranks of become(), whose own
  /// standard output is a pipe or pseudo-terminal of mpirun; else what isatty says.
  bool
  prints_to_terminal();
} // namespace whipple::mpirun
