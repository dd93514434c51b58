// SPDX-License-Identifier: LGPL-2.1-or-later
#pragma once

#include <whipple/mesh/boundary.h>
#include <whipple/mesh/flat_mesh.h>
#include <whipple/state/derived.h>
#include <whipple/state/fields.h>

#include <mpi.h>

#include <vector>

namespace whipple
{
  /// Change of the state over each owned cell: the largest, over density (mass / volume of the cell), pressure and
  /// momentum density (thin gas may swirl as it likes), of the difference to a face neighbour, brought to a distance of
  /// one cell size, as a part of the largest absolute value of that quantity in the scene. 1 for cells with open void
  /// or a neighbour with any (an interface is no smooth place) and at the rim of the active region. Across a reflecting
  /// side lies the mirror image. Collective; one valid layer of halo is read.
  template <int dim>
  std::vector<double>
  change_over_cells(const FlatMesh<dim> &mesh, const State<dim> &state, const Derived &derived,
                    const Boundaries<dim> &boundaries, MPI_Comm communicator);
} // namespace whipple
