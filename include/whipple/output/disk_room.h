// SPDX-License-Identifier: LGPL-2.1-or-later
#pragma once

#include <mpi.h>

#include <cstddef>
#include <string>

namespace whipple
{
  /// Ask before a file is written through HDF5, which a full disk stops in a way that no program survives.
  /// @param path  of a file in a directory that exists
  /// @param bytes that this rank will write into it
  /// @throws Error on all ranks, with what is needed and what is there, unless the disk has room for those of all ranks
  ///         and a little more. Collective.
  void
  require_disk_room(const std::string &path, std::size_t bytes, MPI_Comm communicator);
} // namespace whipple
