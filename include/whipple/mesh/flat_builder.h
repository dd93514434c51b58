// SPDX-License-Identifier: LGPL-2.1-or-later
#pragma once

#include <whipple/mesh/bonds.h>
#include <whipple/mesh/flat_mesh.h>

#include <array>
#include <vector>

namespace whipple
{
  /// The integer grid under the forest: a box of root cells (level 0), each refined at most `max_level` times.
  template <int dim>
  struct Lattice
  {
    Symmetry             symmetry = Symmetry::planar;
    Vector<dim>          origin{};    ///< lower corner of the domain, cm
    double               spacing = 1; ///< edge of a cell at max_level, cm
    std::array<int, dim> roots{};     ///< number of root cells along each axis
    int                  max_level = 0;

    /// Edge of a cell of that level in finest cells.
    int
    extent(int level) const
    {
      return 1 << (max_level - level);
    }
    /// Number of finest cells along an axis of the domain.
    int
    finest(int axis) const
    {
      return roots[axis] << max_level;
    }
  };

  /// Integer coordinates of a cell's lower corner, in finest cells.
  template <int dim>
  using LatticePoint = std::array<int, dim>;

  template <int dim>
  CellKey
  make_key(int level, const LatticePoint<dim> &point)
  {
    CellKey key = static_cast<CellKey>(level) << 57;
    for (int d = 0; d < dim; ++d)
      key |= static_cast<CellKey>(point[d]) << (19 * d);
    return key;
  }

  inline int
  key_level(CellKey key)
  {
    return static_cast<int>(key >> 57);
  }

  template <int dim>
  LatticePoint<dim>
  key_point(CellKey key)
  {
    LatticePoint<dim> point;
    for (int d = 0; d < dim; ++d)
      point[d] = static_cast<int>((key >> (19 * d)) & 0x7ffff);
    return point;
  }

  /// Build the flat view of a set of leaves that do not overlap and are 2:1 balanced over faces and corners.
  /// @param keys  owned cells first, in the order they shall have, then halo cells
  /// @param layer distance of each cell to the owned ones (0 for owned)
  /// @param bonds which cells hold together; a broken one has nodes of its own and no faces
  /// @throws StateError if intact leaves overlap or are out of balance, or bonds are given for another number of cells.
  template <int dim>
  FlatMesh<dim>
  build_flat_mesh(const Lattice<dim> &lattice, std::vector<CellKey> keys, Index n_owned,
                  std::vector<std::uint8_t> layer, int halo_width, const Bonds &bonds);
} // namespace whipple
