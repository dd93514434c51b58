// SPDX-License-Identifier: LGPL-2.1-or-later
#pragma once

#include <whipple/mesh/flat_mesh.h>
#include <whipple/projection/projection_parameters.h>
#include <whipple/state/fields.h>

#include <cstdint>
#include <vector>

namespace whipple
{
  /// Which owned cells have not broken, one flag each. A cell is broken
  ///   - where the state carries damage: when that of its heaviest material (of equals the first) reaches the limit;
  ///   - where it does not: when its voids, those outside the materials included, 1 - sum_m (1 - phi_m) V_m / V, exceed
  ///     their limit;
  ///   - and in any case when it is about to fold: a cell that has deformed so far resists by its shape alone, and
  ///     its time step vanishes.
  template <int dim>
  std::vector<std::uint8_t>
  intact_cells(const FlatMesh<dim> &mesh, const State<dim> &state, const BreakCriteria &criteria);
} // namespace whipple
