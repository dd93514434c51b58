// SPDX-License-Identifier: LGPL-2.1-or-later
#pragma once

#include <whipple/output/snapshot.h>

#include <mpi.h>

#include <span>
#include <string>

/// Snapshots as one HDF5 file a time (all ranks together) and the XDMF text by which ParaView reads them.
namespace whipple::snapshot_hdf5
{
  /// In how many digits fields are stored; positions are always double.
  enum class Precision
  {
    single_precision,
    double_precision
  };

  /// Where a grid is in a time series.
  struct GridPlace
  {
    std::string path;           ///< of the HDF5 file as seen from where the .xdmf will be
    std::string stage;          ///< name of the grid
    double      shown_time = 0; ///< us
  };

  /// Write `path`: datasets nodes (n, dim), cells (n, corners; lexicographic corner order is turned into the walk
  /// around the cell that XDMF wants), velocity (n, 3) and one dataset a field, named like the field with
  /// underscores for what is not a letter or digit, with its unit as attribute; time (the state's, us), stage, units
  /// and version as attributes of the file. Collective; some rank must have cells.
  /// @return the XDMF grid of this time.
  template <int dim>
  std::string
  write(const Snapshot<dim> &snapshot, const std::string &path, const GridPlace &place, Precision precision,
        MPI_Comm communicator);

  /// Write (or rewrite, in one piece) an .xdmf file holding the grids as a time series. Call on one rank.
  /// @throws std::runtime_error if the disk refuses.
  void
  write_series(const std::string &path, std::span<const std::string> grids);
} // namespace whipple::snapshot_hdf5
