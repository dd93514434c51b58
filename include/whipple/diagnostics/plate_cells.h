// SPDX-License-Identifier: LGPL-2.1-or-later
#pragma once

#include <whipple/diagnostics/plate_pieces.h>
#include <whipple/problem/field_layout.h>
#include <whipple/scene/scene.h>

#include <vector>

namespace whipple
{
  /// What of the scene a plate's measures depend on. A plate that the right side alone halves is turned about, as
  /// plate_cells() turns its cells.
  /// @throws Error if the body is no plate.
  template <int dim>
  PlateSite
  plate_site(const Scene<dim> &scene, std::size_t body);

  /// The owned cells that hold material of a plate (by its body tag; without tags of its material).
  template <int dim>
  std::vector<PlateCell>
  plate_cells(const Scene<dim> &scene, const FieldLayout &layout, std::size_t body, const FlatMesh<dim> &mesh,
              const State<dim> &state);
} // namespace whipple
