// SPDX-License-Identifier: LGPL-2.1-or-later
#pragma once

#include <whipple/mesh/flat_mesh.h>
#include <whipple/state/fields.h>

#include <cstdint>
#include <vector>

namespace whipple
{
  /// Corner Jacobian, as a part of the mean of the four, below which a fragment stops deforming.
  inline constexpr double least_jacobian_share = 0.1;

  /// Owned cells with mass that are bonded to others and whose sides would cross after dt at the present velocities.
  template <int dim>
  std::vector<Index>
  folding_cells(const FlatMesh<dim> &mesh, const State<dim> &state, double dt);

  /// Owned cells with mass whose sides cross.
  template <int dim>
  std::vector<Index>
  folded_cells(const FlatMesh<dim> &mesh, const State<dim> &state);
} // namespace whipple
