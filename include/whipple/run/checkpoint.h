// SPDX-License-Identifier: LGPL-2.1-or-later
#pragma once

#include <whipple/run/last_good.h>

#include <mpi.h>

#include <string>

/// One checkpoint: a directory with the whole of a run at a moment, from which it goes on with the same bits on any
/// number of ranks (doc/restart.md says what is in it).
namespace whipple::checkpoint
{
  /// What is wrong with a checkpoint on disk; the message names it.
  class Unusable : public Error
  {
  public:
    using Error::Error;
  };

  /// A checkpoint but its fields, which every rank reads for itself.
  template <int dim>
  struct Header
  {
    std::string   parameters; ///< the scene: every value in force
    RunBooks<dim> books;
  };

  /// Write a state into a new directory: aside, flushed to disk, read back, and renamed when it is whole. Collective.
  /// @throws Unusable on all ranks if the disk refuses; there is no such directory then.
  template <int dim>
  void
  write(const std::string &directory, const FieldLayout &layout, const std::string &parameters,
        const LastGood<dim> &state, MPI_Comm communicator);

  /// Read and check all but the fields. Collective.
  /// @throws Unusable on all ranks: files missing, shortened, altered, or of another version.
  template <int dim>
  Header<dim>
  read_header(const std::string &directory, MPI_Comm communicator);

  /// Rebuild the mesh in the forest of `run` and read the fields onto it. Collective.
  /// @throws Unusable on all ranks if the fields are not those of this layout, or altered.
  template <int dim>
  void
  read_fields(const std::string &directory, const FieldLayout &layout, RunState<dim> &run);
} // namespace whipple::checkpoint
