// SPDX-License-Identifier: LGPL-2.1-or-later
#pragma once

#include <whipple/mesh/cell_geometry.h>
#include <whipple/mesh/flat_mesh.h>
#include <whipple/state/fields.h>

/// What a cell will look like, and whether it stands alone.
namespace whipple::cell_shape
{
  /// Where the corners of a cell will be after dt at their present velocities.
  inline CornerVectors<2>
  corners_after(const FlatMesh<2> &mesh, const State<2> &state, Index cell, double dt)
  {
    CornerVectors<2> x;
    for (int k = 0; k < 4; ++k)
      {
        const Index n = mesh.cell_node[4 * cell + k];
        for (int d = 0; d < 2; ++d)
          x[d][k] = state.position[d][n] + dt * state.velocity[d][n];
      }
    return x;
  }

  /// Whether a cell shares a node with another one.
  inline bool
  shares_nodes(const FlatMesh<2> &mesh, Index cell)
  {
    for (int k = 0; k < 4; ++k)
      {
        const Index n = mesh.cell_node[4 * cell + k];
        if (mesh.node_corner_begin[n + 1] - mesh.node_corner_begin[n] > 1)
          return true;
      }
    return false;
  }
} // namespace whipple::cell_shape
