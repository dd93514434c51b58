// SPDX-License-Identifier: LGPL-2.1-or-later
#pragma once

#include <whipple/mesh/flat_builder.h>
#include <whipple/mesh/halo.h>

#include <memory>
#include <span>
#include <vector>

namespace whipple
{
  /// One rank's part of the active cells as flat arrays, and what keeps its halo fresh. Lives on the heap and
  /// stays there, because the halo refers to the mesh.
  template <int dim>
  struct FlatPartition
  {
    FlatMesh<dim>      mesh;
    Halo<dim>          halo;
    std::vector<Index> leaf_of_cell; ///< [mesh.n_owned] which of this rank's leaves the cell is

    FlatPartition()                      = default;
    FlatPartition(const FlatPartition &) = delete;
    FlatPartition &
    operator=(const FlatPartition &) = delete;
  };

  /// Flatten the active leaves. Owned cells keep the forest's order; the halo is every active cell of another rank
  /// within `halo_width` steps from cell to touching cell (face or corner) of an owned one, ordered by key.
  /// Collective; every rank learns the keys of all active cells (8 B each).
  /// @param leaves this rank's leaves; those of all ranks are 2:1 balanced over corners
  /// @param active nonzero for leaves to flatten
  /// @param bonds  uniform, or one entry for each leaf
  /// @throws StateError if lengths differ.
  template <int dim>
  std::unique_ptr<FlatPartition<dim>>
  flatten_leaves(MPI_Comm communicator, const Lattice<dim> &lattice, std::span<const CellKey> leaves,
                 std::span<const std::uint8_t> active, int halo_width, const Bonds &bonds);
} // namespace whipple
