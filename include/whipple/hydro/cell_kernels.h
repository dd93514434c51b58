// SPDX-License-Identifier: LGPL-2.1-or-later
#pragma once

#include <whipple/hydro/hydro_parameters.h>
#include <whipple/hydro/step_work.h>
#include <whipple/material/material.h>

#include <vector>

/// The three passes of a Lagrange step over cells, each a loop over packs of cells.
/// Equations: doc/theory/lagrange_step.md.
namespace whipple::cell_kernels
{
  /// What the energy pass turned into heat in owned cells, Mbar cm^3.
  struct Dissipation
  {
    double viscous   = 0;
    double hourglass = 0;
    double plastic   = 0;
  };

  /// work.mass and work.stretch_rate at half step (0 in cells without mass): what the limiter of the
  /// artificial viscosity compares between neighbours.
  template <int dim>
  void
  stretch_rates(const FlatMesh<dim> &mesh, const State<dim> &state, StepWork<dim> &work);

  /// work.corner_force, work.half_step and half-step pressures from positions and stresses at half step.
  template <int dim>
  void
  corner_forces(const FlatMesh<dim> &mesh, const State<dim> &state, const HydroParameters &parameters, double dt,
                StepWork<dim> &work);

  /// Next volume, and next volume, density, energy, stress and plastic strain of every material, from
  /// work.position, work.mean_velocity and the corner forces.
  /// @throws StateError if the volume of an owned cell or of a material in it would not stay positive.
  template <int dim>
  Dissipation
  update_cells(const FlatMesh<dim> &mesh, const State<dim> &state, double dt, StepWork<dim> &work);
} // namespace whipple::cell_kernels
