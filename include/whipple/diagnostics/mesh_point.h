// SPDX-License-Identifier: LGPL-2.1-or-later
#pragma once

#include <whipple/mesh/flat_builder.h>
#include <whipple/mesh/flat_mesh.h>
#include <whipple/state/fields.h>

/// Points in a mesh: which cell holds them, and what the nodes say there.
namespace whipple
{
  /// A point by its cell and its place in the unit square of which the cell is the bilinear image.
  template <int dim>
  struct MeshPoint
  {
    Index       cell = none; ///< owned; none: no such cell here
    Vector<dim> local{};
  };

  /// The owned cell of this key.
  template <int dim>
  Index
  cell_of_key(const FlatMesh<dim> &mesh, CellKey key);

  /// The owned cell with material that holds a point of an undeformed mesh. A point on a face belongs to the cell above
  /// it, at the upper end of the domain to the last one: to one cell of all ranks.
  template <int dim>
  MeshPoint<dim>
  find_in_lattice(const Lattice<dim> &lattice, const FlatMesh<dim> &mesh, const State<dim> &state,
                  const Vector<dim> &x);

  /// The owned element with material that holds a point where the nodes are now; of several (on a face, or where pieces
  /// overlap) the one of least key.
  template <int dim>
  MeshPoint<dim>
  find_in_elements(const FlatMesh<dim> &mesh, const State<dim> &state, const Vector<dim> &x);

  /// A vector that sits on the nodes (positions, velocities), at a point: sum N_k(local) u_k.
  template <int dim>
  Vector<dim>
  at_point(const FlatMesh<dim> &mesh, const std::array<std::vector<double>, dim> &nodal, const MeshPoint<dim> &point);
} // namespace whipple
