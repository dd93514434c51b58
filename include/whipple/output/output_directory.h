// SPDX-License-Identifier: LGPL-2.1-or-later
#pragma once

#include <whipple/output/directory_lock.h>

#include <mpi.h>

#include <string>

namespace whipple
{
  /// Make `directory` ready for a new run: create it with its parents, or clear what an earlier run of Whipple
  /// wrote into it (files this code does not write stay). Collective; only rank 0 touches the disk.
  /// @throws InputError on every rank if it exists, is not empty and is not the output of a Whipple run
  ///         (a Whipple log.txt is what marks one), if it cannot be created, or if another run is writing into it.
  /// @returns keeps others out; held by the first rank
  DirectoryLock
  prepare_output_directory(const std::string &directory, MPI_Comm communicator);
} // namespace whipple
