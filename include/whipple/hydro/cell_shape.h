// SPDX-License-Identifier: LGPL-2.1-or-later
#pragma once

#include <whipple/mesh/flat_mesh.h>
#include <whipple/mesh/geometry.h>
#include <whipple/state/fields.h>

#include <algorithm>

/// Whether a quadrilateral is still one.
namespace whipple::cell_shape
{
  /// Where the corners of a cell will be after dt at their present velocities.
  inline geometry::Quad
  corners_after(const FlatMesh<2> &mesh, const State<2> &state, Index cell, double dt)
  {
    geometry::Quad x;
    for (int k = 0; k < 4; ++k)
      {
        const Index n = mesh.cell_node[4 * cell + k];
        for (int d = 0; d < 2; ++d)
          x[d][k] = state.position[d][n] + dt * state.velocity[d][n];
      }
    return x;
  }

  /// Whether the smallest corner Jacobian is below this part of the mean of the four, or the mean is not positive.
  inline bool
  folds(const geometry::Quad &x, double least_jacobian)
  {
    const auto   j    = geometry::corner_jacobian(x);
    const double mean = 0.25 * (j[0] + j[1] + j[2] + j[3]);
    return !(std::min(std::min(j[0], j[1]), std::min(j[2], j[3])) >= least_jacobian * mean && mean > 0);
  }

  /// Whether sides cross (two corners turned over) or the whole is turned over. An arrowhead, one reflex corner, is
  /// not: it covers the area that it is taken to have.
  inline bool
  crosses(const geometry::Quad &x)
  {
    int    turned = 0;
    double sum    = 0;
    for (const double j : geometry::corner_jacobian(x))
      {
        turned += !(j >= 0);
        sum += j;
      }
    return turned > 1 || !(sum > 0);
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
