// SPDX-License-Identifier: LGPL-2.1-or-later
#pragma once

#include <whipple/hydro/hydro_parameters.h>
#include <whipple/hydro/step_work.h>
#include <whipple/material/material.h>
#include <whipple/state/derived.h>

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

  /// sqrt(2/3 D':D') of the deviatoric rate of deformation D' at the positions and velocities of the state, 1/us, of
  /// every cell.
  template <int dim>
  void
  strain_rates(const FlatMesh<dim> &mesh, const State<dim> &state, std::vector<double> &rate);

  /// work.corner_force, work.half_step and half-step pressures from positions and stresses at half step.
  template <int dim>
  void
  corner_forces(const FlatMesh<dim> &mesh, const State<dim> &state, const Derived &derived,
                const HydroParameters &parameters, double dt, StepWork<dim> &work);

  /// The same with one kind of viscosity, whatever the parameters say.
  template <int dim>
  void
  corner_forces_scalar(const FlatMesh<dim> &mesh, const State<dim> &state, const Derived &derived,
                       const HydroParameters &parameters, double dt, StepWork<dim> &work);
  template <int dim>
  void
  corner_forces_tensor(const FlatMesh<dim> &mesh, const State<dim> &state, const Derived &derived,
                       const HydroParameters &parameters, double dt, StepWork<dim> &work);

  /// Kinetic energy that work.viscous_force turns into heat in owned cells, Mbar cm^3.
  template <int dim>
  double
  viscous_work(const FlatMesh<dim> &mesh, double dt, const StepWork<dim> &work);

  /// Next volume, and next volume, density, energy, stress and plastic strain of every material, from
  /// work.position, work.mean_velocity and the corner forces.
  /// @throws StateError if the volume of an owned cell or of a material in it would not stay positive.
  template <int dim>
  Dissipation
  update_cells(const FlatMesh<dim> &mesh, const State<dim> &state, const Derived &derived, double dt,
               StepWork<dim> &work);
} // namespace whipple::cell_kernels
