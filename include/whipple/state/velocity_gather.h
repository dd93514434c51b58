// SPDX-License-Identifier: LGPL-2.1-or-later
#pragma once

#include <whipple/mesh/boundary.h>
#include <whipple/mesh/flat_mesh.h>
#include <whipple/state/booking.h>
#include <whipple/state/corner_velocity.h>
#include <whipple/state/fields.h>

namespace whipple
{
  /// Make nodes of corner velocities: node masses m = C^T (corner masses) and v = momentum / mass, so that
  /// momentum is exact; hanging nodes give half their momentum to each master and follow them. Corner masses
  /// are corner_weight * cell mass. Corners that agree keep their bits. Nodes on
  /// reflecting sides get no normal velocity. Nodes without mass rest. A hanging corner passes the
  /// difference of its masters on as far as the cell's kinetic remainder pays for it, so that nodes made of the
  /// corner velocities of nodes are the same nodes. The kinetic energy lost,
  ///     sum over corners of m |u - v|^2/2 + kinetic remainder that is left,
  /// heats the cells or is dropped (doc/theory/refinement.md).
  ///
  /// Works on all cells and nodes; corner values in the halo must be the owners'.
  /// @param state  masses, corner weights in; velocity, node_mass (and energy) out
  /// @returns summed over owned cells: kinetic energy converted (never less than 0 beyond round-off) and, as what left,
  ///          the impulse given to reflecting sides, which allow no normal velocity
  template <int dim>
  Booking<dim>
  gather_velocities(const FlatMesh<dim> &mesh, const Boundaries<dim> &boundaries, const CornerVelocities<dim> &corners,
                    KineticLoss loss, State<dim> &state);

  /// Sum over this rank's share of the nodes of m v^2/2: every owned cell counts its corners, so that sums over
  /// ranks count each node once. Mbar cm^3.
  template <int dim>
  double
  kinetic_energy(const FlatMesh<dim> &mesh, const State<dim> &state);

  /// Sum over this rank's owned cells' corners of m v along each axis, g cm/us.
  template <int dim>
  Vector<dim>
  momentum(const FlatMesh<dim> &mesh, const State<dim> &state);
} // namespace whipple
