// SPDX-License-Identifier: LGPL-2.1-or-later
#pragma once

#include <whipple/output/snapshot.h>

#include <mpi.h>

#include <string>

/// Snapshots as VTU files (VTK's XML format for unstructured grids). deal.II's writer has data of points alone; here
/// fields of cells are cell data, on nodes that cells share. Single precision, positions double; units in the names.
namespace whipple::snapshot_vtu
{
  /// Write `path`, one file for all ranks, a piece each. Collective.
  /// @throws Error on all ranks if the disk refuses
  template <int dim>
  void
  write(const Snapshot<dim> &snapshot, const std::string &path, MPI_Comm communicator);
} // namespace whipple::snapshot_vtu
