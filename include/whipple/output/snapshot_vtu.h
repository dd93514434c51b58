// SPDX-License-Identifier: LGPL-2.1-or-later
#pragma once

#include <whipple/output/snapshot.h>

#include <mpi.h>

#include <string>

/// Snapshots as VTU through deal.II's writer: each cell is a patch with its own corners, so that a cell field is
/// constant over it.
namespace whipple::snapshot_vtu
{
  /// Write `path`, one file for all ranks. Collective.
  template <int dim>
  void
  write(const Snapshot<dim> &snapshot, const std::string &path, MPI_Comm communicator);
} // namespace whipple::snapshot_vtu
