// SPDX-License-Identifier: LGPL-2.1-or-later
#pragma once

#include <whipple/diagnostics/plate_pieces.h>
#include <whipple/problem/field_layout.h>
#include <whipple/scene/scene.h>

#include <mpi.h>

#include <optional>
#include <vector>

namespace whipple
{
  /// What an impact has done to a plate, measured on the plate's own material where it is now, by what of it still
  /// hangs together with its rim (doc/theory/measures.md).
  struct PlateMeasure
  {
    bool perforated = false; ///< no attached material bars the way from front to rear
    /// cm, how sure that is: the narrowest width of the opening, or minus the thickness of the thinnest place.
    double perforation_margin     = 0;
    double hole_diameter          = 0; ///< cm, between the hole's edges at the middle of the plate beside them
    double smallest_hole_diameter = 0; ///< cm, free for a straight line of flight along axis 1
    double crater_depth           = 0; ///< cm from the undisturbed front plane; perforated: the plate's thickness
    double rear_bulge             = 0; ///< cm of attached material behind the undisturbed rear plane
    double front_lip              = 0; ///< cm of attached material before the undisturbed front plane
    double least_thickness        = 0; ///< cm of solid left on the thinnest line of flight
    double detached_mass          = 0; ///< g of the plate's material in the domain that hangs together with no rim
  };

  /// Measure a plate from the cells that hold its material, all of them.
  /// @returns nothing if the plate cannot be seen: it is thinner than a cell, lies in cells larger than its thickness,
  /// or
  ///          next to nothing of it is left in the domain.
  std::optional<PlateMeasure>
  measure_plate(const PlateSite &site, std::vector<PlateCell> cells);

  /// Measure a plate-shaped body of the scene; the same bits on all ranks, whatever their number. Collective; the first
  /// rank alone holds the image.
  /// @throws Error if the body is no plate.
  template <int dim>
  std::optional<PlateMeasure>
  measure_plate(const Scene<dim> &scene, const FieldLayout &layout, std::size_t body, const FlatMesh<dim> &mesh,
                const State<dim> &state, MPI_Comm communicator);

  /// Plates that are measured at the end of a stage: Eulerian stages measure those that have entered since the last
  /// Lagrangian stage (what that one has dropped is no longer there).
  template <int dim>
  std::vector<std::size_t>
  measured_plates(const Scene<dim> &scene, std::size_t stage);
} // namespace whipple
