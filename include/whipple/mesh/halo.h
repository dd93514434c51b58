// SPDX-License-Identifier: LGPL-2.1-or-later
#pragma once

#include <whipple/mesh/flat_mesh.h>

#include <mpi.h>

#include <span>
#include <vector>

namespace whipple
{
  /// Brings owners' values into the halo of a FlatMesh. Kernels run over owned and halo cells alike and know
  /// nothing of ranks; after each of them the outermost layers hold stale values until the next exchange.
  template <int dim>
  class Halo
  {
  public:
    /// One neighbouring rank: which owned cells it wants, and where what it sends goes.
    struct Neighbour
    {
      int                rank;
      std::vector<Index> send;    ///< owned cells, ordered by key
      std::vector<Index> receive; ///< halo cells, ordered by key
    };

    Halo() = default;
    Halo(MPI_Comm communicator, const FlatMesh<dim> &mesh, std::vector<Neighbour> neighbours);

    /// Refresh cell arrays (length n_cells) and node arrays (length n_nodes). Node values travel with the
    /// corners of the cells sent, so every node of a halo cell gets its owner's bits. One message a neighbour.
    void
    exchange(std::span<std::vector<double> *const> cell_arrays,
             std::span<std::vector<double> *const> node_arrays) const;

    /// Refresh arrays with `corners` values a cell (length n_cells * corners).
    void
    exchange_corners(std::span<std::vector<double> *const> corner_arrays) const;

    MPI_Comm
    communicator() const
    {
      return communicator_;
    }

  private:
    /// Messages to and from one neighbour; they only grow, so that a step allocates nothing.
    struct Buffers
    {
      std::vector<double> send, receive;
    };

    void
    exchange_all(std::span<std::vector<double> *const> cell_arrays, std::span<std::vector<double> *const> node_arrays,
                 std::span<std::vector<double> *const> corner_arrays) const;

    MPI_Comm               communicator_ = MPI_COMM_SELF;
    const FlatMesh<dim>   *mesh_         = nullptr;
    std::vector<Neighbour> neighbours_;

    mutable std::vector<Buffers>     buffers_;
    mutable std::vector<MPI_Request> requests_;
  };
} // namespace whipple
