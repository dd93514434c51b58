// SPDX-License-Identifier: LGPL-2.1-or-later
#pragma once

#include <whipple/mesh/forest.h>

#include <cstdint>
#include <memory>
#include <vector>

namespace whipple
{
  /// The mesh of a run as a value: all leaves of all ranks in forest order, the same on every rank and for every number
  /// of ranks. A mesh that is rebuilt from it gives the same bits, however its leaves are spread.
  struct MeshImage
  {
    std::vector<CellKey>      leaf;
    std::vector<std::uint8_t> active;         ///< [leaf] nonzero: part of the flat mesh
    std::vector<std::uint8_t> intact;         ///< [leaf] nonzero: an active leaf that holds on to its neighbours
    int                       halo_width = 0; ///< layers of neighbours around a rank's cells

    std::size_t
    n_active() const;
  };

  /// Take the image of a forest and the view of its active part. Collective; every rank gets all of it.
  template <int dim>
  MeshImage
  image_of(const Forest<dim> &forest, const FlatPartition<dim> &view);

  /// Bring a forest over the same lattice to the leaves of an image, spread its active leaves evenly over the ranks,
  /// and flatten them. Collective.
  /// @throws StateError if the leaves are none of a forest over this lattice.
  template <int dim>
  std::unique_ptr<FlatPartition<dim>>
  rebuild(const MeshImage &image, Forest<dim> &forest);
} // namespace whipple
