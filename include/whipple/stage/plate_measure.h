// SPDX-License-Identifier: LGPL-2.1-or-later
#pragma once

#include <whipple/scene/scene.h>
#include <whipple/stage/field_layout.h>

#include <mpi.h>

namespace whipple
{
  /// What an impact has done to a plate, measured on the plate's own material (by its body tag; without tags on
  /// all material) inside the box it filled at the start, on the finest cells.
  struct PlateMeasure
  {
    /// Twice the radius of the hole at mid-plane: from outside inwards, where the plate's solid volume fraction
    /// sum V_m (1 - phi_m) / V falls below 1/2 for the first time, linear within that cell. 0: closed.
    double hole_diameter          = 0;     ///< cm
    double smallest_hole_diameter = 0;     ///< cm, the same in the layer where it is narrowest
    bool   perforated             = false; ///< some column through the plate has no cell that is half solid
    double crater_depth           = 0; ///< cm from the original front face to the first half-solid cell, deepest column
    double least_thickness        = 0; ///< cm of solid left in the thinnest column
  };

  /// Measure a plate-shaped body of the scene. Collective.
  /// @throws Error if the body is no plate.
  template <int dim>
  PlateMeasure
  measure_plate(const Scene<dim> &scene, const FieldLayout &layout, std::size_t body, const FlatMesh<dim> &mesh,
                const State<dim> &state, MPI_Comm communicator);
} // namespace whipple
