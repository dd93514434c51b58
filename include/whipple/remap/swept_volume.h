// SPDX-License-Identifier: LGPL-2.1-or-later
#pragma once

#include <whipple/mesh/flat_mesh.h>
#include <whipple/state/fields.h>

#include <vector>

namespace whipple
{
  /// Signed volume [cm^3] that every subface normal to `axis` sweeps on its way from state.position back to the
  /// undeformed mesh: what the cell below the face gains and the one above it loses. The face is straight before and
  /// after, so swept volumes are those of quadrilaterals (of revolution) and V_moved + sum = V_fixed holds to
  /// round-off, hanging nodes included. The quadrilateral is measured by two triangles, so that small displacements
  /// lose no digits. `swept` has one entry a face and is not resized.
  template <int dim>
  void
  compute_swept_volumes(const FlatMesh<dim> &mesh, const State<dim> &state, int axis, std::vector<double> &swept);
} // namespace whipple
