// SPDX-License-Identifier: LGPL-2.1-or-later
#pragma once

#include <whipple/mesh/index.h>

#include <concepts>
#include <cstdint>
#include <vector>

namespace whipple
{
  /// Identity of a leaf of the forest, the same on every rank: its level and the integer coordinates of
  /// its lower corner, in units of the finest cell the forest can have.
  /// Packed as level (6 bits) | z (19) | y (19) | x (19) so that keys order and hash cheaply.
  using CellKey = std::uint64_t;

  /// Faces normal to one axis, one entry per subface: a coarse face with a hanging node is two entries.
  template <int dim>
  struct FlatFaces
  {
    static constexpr int corners = 1 << (dim - 1);

    /// Cell below [0] and above [1] the face along its axis; `none` where the active region, the domain
    /// or the bonded body ends.
    std::array<std::vector<Index>, 2> cell;

    /// Which part of that cell's face this subface is: -1 all of it, else the transverse half (bit t set
    /// for the upper half of transverse direction t).
    std::array<std::vector<std::int8_t>, 2> part;

    /// Nodes of the subface, corners entries each, lexicographic in the transverse directions.
    std::vector<Index> node;

    /// Side of the domain the face lies on (2*axis + {0 lower, 1 upper}), -1 in the interior and where
    /// the active region ends inside the domain.
    std::vector<std::int8_t> side;

    Index
    size() const
    {
      return static_cast<Index>(side.size());
    }
  };

  /// The nodes that a hanging node hangs on, each with the same weight. Its position, velocity and all else that is
  /// linear is their mean; its mass, momentum and the forces on it are shared out among them.
  template <int dim>
  struct Masters;

  /// The two ends of the coarse edge that the node is the middle of.
  template <>
  struct Masters<2>
  {
    std::array<Index, 2> node;

    static constexpr double weight = 0.5; ///< of each

    const Index *
    begin() const
    {
      return node.data();
    }
    const Index *
    end() const
    {
      return node.data() + node.size();
    }
    Index
    operator[](std::size_t i) const
    {
      return node[i];
    }

    /// The ends, for what holds on an edge only: differences along it.
    const std::array<Index, 2> &
    ends() const
    {
      return node;
    }

    /// Mean of value(node).
    template <std::invocable<Index> Value>
    double
    mean(Value value) const
    {
      return 0.5 * (value(node[0]) + value(node[1]));
    }
    double
    mean(const std::vector<double> &nodal) const
    {
      return 0.5 * (nodal[node[0]] + nodal[node[1]]);
    }
  };

  /// The active part of the forest as flat arrays; topology only, rebuilt at every regrid.
  ///
  /// Cells [0, n_owned) are this rank's, in the forest's order; [n_owned, n_cells) are the halo: every
  /// cell of other ranks within `halo_width` vertex neighbours of an owned cell. Nodes are classes of cell
  /// corners: corners that meet across a bonded face, one between two intact cells, are one node.
  /// All orders that enter a sum depend on geometry alone, never on the partition.
  template <int dim>
  struct FlatMesh
  {
    static constexpr int corners  = 1 << dim;
    static constexpr int subfaces = 1 << (dim - 1);

    Symmetry symmetry   = Symmetry::planar;
    Index    n_owned    = 0;
    Index    n_cells    = 0;
    Index    n_nodes    = 0;
    int      halo_width = 0;

    std::vector<CellKey>      key;    ///< [n_cells]
    std::vector<std::uint8_t> level;  ///< [n_cells]
    std::vector<std::uint8_t> layer;  ///< [n_cells] 0 owned, else vertex-neighbour distance to an owned cell
    std::vector<std::uint8_t> intact; ///< [n_cells] 0: a broken cell or fragment, with nodes of its own and no faces

    /// Undeformed box of the cell: its lower corner and its edge length (cells are square), cm.
    std::array<std::vector<double>, dim> lower;
    std::vector<double>                  size;

    /// [n_cells * corners] node of corner k (lexicographic: bit d of k = upper along axis d).
    std::vector<Index> cell_node;

    /// Corners of a node (entries cell * corners + k), node by node, ordered by the position of the cell
    /// around the node.
    std::vector<Index> node_corner_begin; ///< [n_nodes + 1]
    std::vector<Index> node_corner;

    /// Undeformed position of the node, cm, and the sides of the domain it lies on (bit 2*axis + upper).
    std::array<std::vector<double>, dim> node_point;
    std::vector<std::uint8_t>            node_side;

    /// Hanging nodes, ordered by position, and what each hangs on. Masters never hang themselves (the forest is
    /// balanced over corners).
    std::vector<Index>        hanging;
    std::vector<Masters<dim>> master;

    /// Give every hanging node the mean of its masters.
    void
    hang(std::vector<double> &nodal) const
    {
      for (std::size_t h = 0; h < hanging.size(); ++h)
        nodal[hanging[h]] = master[h].mean(nodal);
    }

    /// Share out what hanging nodes hold among their masters; it stays with the hanging nodes too.
    void
    share_out(std::vector<double> &nodal) const
    {
      for (std::size_t h = 0; h < hanging.size(); ++h)
        for (const Index m : master[h])
          nodal[m] += Masters<dim>::weight * nodal[hanging[h]];
    }

    std::array<FlatFaces<dim>, dim> faces;

    /// [side = 2*axis + upper][cell * subfaces + s]: the subfaces of each side of each cell, `none`-padded,
    /// in transverse order.
    std::array<std::vector<Index>, 2 * dim> cell_face;
  };
} // namespace whipple
