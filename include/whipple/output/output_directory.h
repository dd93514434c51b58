// SPDX-License-Identifier: LGPL-2.1-or-later
#pragma once

#include <whipple/output/directory_lock.h>

#include <mpi.h>

#include <string>

namespace whipple
{
  /// What becomes of a run that the directory of a new one holds.
  enum class EarlierRun
  {
    refused,
    replaced
  };

  /// Where a new run goes that shall keep earlier ones: the directory asked for, or if that holds a run, the first free
  /// one of DIR-2, DIR-3 ... One that another process is writing into is returned as it is, to be refused.
  std::string
  free_output_directory(const std::string &asked);

  /// Make `directory` ready for a new run: create it with its parents, or, where an earlier run shall be replaced,
  /// remove what its manifest lists (other files stay). Collective; only rank 0 touches the disk.
  /// @throws InputError on every rank if it cannot be created, another run is writing into it, or it exists and is
  ///         neither empty nor the output of a Whipple run (a Whipple log.txt marks one), or holds one that is refused
  ///         or has no manifest
  /// @returns keeps others out; held by the first rank
  DirectoryLock
  prepare_output_directory(const std::string &directory, EarlierRun earlier, MPI_Comm communicator);
} // namespace whipple
