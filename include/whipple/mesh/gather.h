// SPDX-License-Identifier: LGPL-2.1-or-later
#pragma once

#include <mpi.h>

#include <numeric>
#include <span>
#include <type_traits>
#include <vector>

namespace whipple
{
  /// The concatenation of all ranks' lists, in the order of ranks.
  template <class T>
  struct Gathered
  {
    std::vector<T>   entry;
    std::vector<int> first; ///< [ranks + 1] where each rank's part begins
  };

  /// Collective; plain data only. Every rank gets everything: meant for a few bytes a leaf at a regrid.
  template <class T>
  Gathered<T>
  gather_all(MPI_Comm communicator, std::span<const T> local)
  {
    static_assert(std::is_trivially_copyable_v<T>);
    int ranks;
    MPI_Comm_size(communicator, &ranks);
    std::vector<int> count(ranks);
    const int        n = static_cast<int>(local.size());
    MPI_Allgather(&n, 1, MPI_INT, count.data(), 1, MPI_INT, communicator);

    Gathered<T> all;
    all.first.assign(ranks + 1, 0);
    for (int r = 0; r < ranks; ++r)
      all.first[r + 1] = all.first[r] + count[r];
    all.entry.resize(all.first[ranks]);

    MPI_Datatype type;
    MPI_Type_contiguous(sizeof(T), MPI_BYTE, &type);
    MPI_Type_commit(&type);
    MPI_Allgatherv(local.data(), n, type, all.entry.data(), count.data(), all.first.data(), type, communicator);
    MPI_Type_free(&type);
    return all;
  }

  /// The concatenation of all ranks' lists, in the order of ranks, on the first rank; empty on the others. Collective;
  /// plain data only.
  template <class T>
  std::vector<T>
  gather_on_first(MPI_Comm communicator, std::span<const T> local)
  {
    static_assert(std::is_trivially_copyable_v<T>);
    int ranks, rank;
    MPI_Comm_size(communicator, &ranks);
    MPI_Comm_rank(communicator, &rank);
    std::vector<int> count(rank == 0 ? ranks : 0), first(rank == 0 ? ranks + 1 : 0, 0);
    const int        n = static_cast<int>(local.size());
    MPI_Gather(&n, 1, MPI_INT, count.data(), 1, MPI_INT, 0, communicator);
    std::partial_sum(count.begin(), count.end(), first.empty() ? first.begin() : first.begin() + 1);
    std::vector<T> all(rank == 0 ? first.back() : 0);

    MPI_Datatype type;
    MPI_Type_contiguous(sizeof(T), MPI_BYTE, &type);
    MPI_Type_commit(&type);
    MPI_Gatherv(local.data(), n, type, all.data(), count.data(), first.data(), type, 0, communicator);
    MPI_Type_free(&type);
    return all;
  }
} // namespace whipple
