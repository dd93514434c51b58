// SPDX-License-Identifier: LGPL-2.1-or-later
#pragma once

#include <whipple/mesh/cell_geometry.h>
#include <whipple/mesh/flat_mesh.h>

namespace whipple
{
  /// Values of a nodal vector field, the positions of the nodes for one, at the corners of a cell.
  template <int dim, typename NodalField>
  inline CornerVectors<dim>
  cell_corners(const FlatMesh<dim> &mesh, const NodalField &nodal, Index cell)
  {
    CornerVectors<dim> value;
    for (int k = 0; k < FlatMesh<dim>::corners; ++k)
      for (int d = 0; d < dim; ++d)
        value[d][k] = nodal[d][mesh.cell_node[cell * FlatMesh<dim>::corners + k]];
    return value;
  }
} // namespace whipple
