// SPDX-License-Identifier: LGPL-2.1-or-later
#pragma once

#include <deal.II/base/hdf5.h>

#include <mpi.h>

#include <cstdint>
#include <string>
#include <vector>

/// Tables in parallel HDF5 files: every rank has some of the rows, one rank's after the other's.
namespace whipple::hdf5_table
{
  /// Where the rows of this rank lie among those of all ranks.
  struct Rows
  {
    std::uint64_t offset = 0, local = 0, global = 0;
  };

  /// @param local number of this rank's rows. Collective.
  inline Rows
  rows_of(std::uint64_t local, MPI_Comm communicator)
  {
    Rows rows{0, local, 0};
    int  rank = 0;
    MPI_Comm_rank(communicator, &rank);
    MPI_Exscan(&local, &rows.offset, 1, MPI_UINT64_T, MPI_SUM, communicator);
    if (rank == 0) // MPI leaves it undefined there
      rows.offset = 0;
    MPI_Allreduce(&local, &rows.global, 1, MPI_UINT64_T, MPI_SUM, communicator);
    return rows;
  }

  /// Write a table of `width` columns (width 1: a plain list), every rank its rows. Collective.
  template <typename Number>
  dealii::HDF5::DataSet
  write(const dealii::HDF5::Group &group, const std::string &name, const std::vector<Number> &values, const Rows &rows,
        std::size_t width)
  {
    std::vector<hsize_t> global{rows.global}, offset{rows.offset}, count{rows.local};
    if (width > 1)
      {
        global.push_back(width);
        offset.push_back(0);
        count.push_back(width);
      }
    dealii::HDF5::DataSet table = group.create_dataset<Number>(name, global);
    if (rows.local > 0)
      table.write_hyperslab(values, offset, count);
    else if (rows.global > 0) // a table without a row has no place in the file: HDF5 fails on several ranks
      table.template write_none<Number>();
    return table;
  }
} // namespace whipple::hdf5_table
