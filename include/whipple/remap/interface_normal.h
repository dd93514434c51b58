// SPDX-License-Identifier: LGPL-2.1-or-later
#pragma once

#include <whipple/mesh/flat_mesh.h>
#include <whipple/state/packet_layout.h>

namespace whipple
{
  /// Out-of-material unit normals of all materials' interfaces: minus the gradient of the volume fraction
  /// averaged to the nodes (volume-weighted mean of the cells around a node; hanging nodes: mean of their
  /// masters), evaluated at the cell's centre. Zero where the cell is full or empty of the material. Used
  /// where packets are made of cells (refinement); the sweeps of the remap reconstruct in the same way.
  template <int dim>
  InterfaceNormals<dim>
  interface_normals(const FlatMesh<dim> &mesh, const State<dim> &state);
} // namespace whipple
