// SPDX-License-Identifier: LGPL-2.1-or-later
#pragma once

#include <whipple/mesh/flat_mesh.h>
#include <whipple/state/fields.h>

#include <array>
#include <cstdint>
#include <span>
#include <vector>

namespace whipple
{
  /// What kind of gather a node needs when momentum moves.
  enum class NodeKind : std::uint8_t
  {
    interior, ///< equal cells all around, no uneven or hanging neighbour, not on a side
    special,  ///< uneven, or neighbour of an uneven or hanging node, or at the end of the mesh
    hanging   ///< moves with its masters
  };

  /// Nodes as the momentum sweeps see them.
  template <int dim>
  struct NodeTopology
  {
    explicit NodeTopology(const FlatMesh<dim> &mesh);

    std::vector<NodeKind> kind;
    std::vector<Index>    hanging_place; ///< [node] place in FlatMesh::hanging, else none

    /// [node] cells of several sizes meet here, or other nodes hang on it (it does not hang itself).
    std::vector<std::uint8_t> uneven;

    /// [axis][node] nearest node along -/+ axis, which may hang; the node itself at the end of the mesh and for hanging
    /// nodes: no slope there.
    std::array<std::vector<Index>, dim> previous, next;

    /// [axis] cells with two subfaces on a side normal to the axis.
    std::array<std::vector<Index>, dim> coarse_cells;

    /// [axis] nodes of faces on the sides of the domain normal to the axis.
    std::array<std::vector<Index>, dim> side_nodes;

    /// Hanging nodes that a master leads, in the order of FlatMesh::hanging.
    std::span<const Index>
    hanging_of(const Index master) const
    {
      return {hanging_.data() + hanging_begin_[master], hanging_.data() + hanging_begin_[master + 1]};
    }

    bool
    on_side(const Index node, const int axis) const
    {
      return on_side_[node] >> axis & 1;
    }

    /// Share of a cell's mass in its corners t (0 lower, 1 upper) across the axis.
    static double
    transverse_share(const State<dim> &state, const Index cell, const int axis, const int t)
    {
      const int first = t ? 3 ^ (1 << axis) : 0;
      return state.corner_weight[4 * cell + first] + state.corner_weight[4 * cell + (first | (1 << axis))];
    }

  private:
    std::vector<Index>        hanging_begin_, hanging_;
    std::vector<std::uint8_t> on_side_; ///< [node] bit per axis
  };
} // namespace whipple
