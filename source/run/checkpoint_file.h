// SPDX-License-Identifier: LGPL-2.1-or-later
#pragma once

#include <whipple/mesh/mesh_image.h>
#include <whipple/run/state_rows.h>

#include <mpi.h>

#include <map>
#include <string>
#include <vector>

/// The HDF5 file of a checkpoint: leaves, flags and rows as datasets, each with its checksum.
namespace whipple::checkpoint_file
{
  /// Checksum of each dataset, by name: the same for every number of ranks, so that two states can be told apart by it.
  using Checksums = std::map<std::string, std::string>;

  /// Collective; rows are those of each rank, the mesh is the same on all.
  Checksums
  write(const std::string &path, const MeshImage &mesh, const std::vector<std::string> &columns, const StateRows &rows,
        double time, MPI_Comm communicator);

  /// Collective; every rank gets all of it.
  /// @throws StateError on all ranks if a checksum is wrong.
  MeshImage
  read_mesh(const std::string &path, MPI_Comm communicator);

  struct Fields
  {
    double    time = 0; ///< us
    StateRows rows;
  };

  /// Collective. @param count rows that this rank takes; the ranks' parts follow each other
  /// @throws StateError on all ranks if a checksum is wrong, or the columns are others.
  Fields
  read_rows(const std::string &path, const std::vector<std::string> &columns, std::size_t count, MPI_Comm communicator);
} // namespace whipple::checkpoint_file
