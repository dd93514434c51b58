// SPDX-License-Identifier: LGPL-2.1-or-later
#pragma once

#include <whipple/mesh/boundary.h>
#include <whipple/mesh/flat_mesh.h>
#include <whipple/state/booking.h>
#include <whipple/state/conserved_totals.h>
#include <whipple/state/fields.h>

#include <span>
#include <string>

namespace whipple
{
  /// What a projection onto elements did, over owned elements.
  template <int dim>
  struct TakenUp
  {
    ConservedTotals<dim> before;  ///< of the kept cells in the Eulerian state
    ConservedTotals<dim> after;   ///< of the elements
    Booking<dim>         booking; ///< kinetic energy lost at former hanging nodes (where a bonded mesh loses neighbours
                                  ///< nothing), impulse given to reflecting sides
  };

  /// Eulerian -> Lagrangian: every cell of `elements` takes over the cell of `cells` with the same key. Shape, masses,
  /// e, fields and corner masses stay; open void is folded into the voids of the materials,
  ///     V_m' = V_m / f,   1 - phi_m' = (1 - phi_m) f,   f = sum_m V_m / V_cell,
  /// so that gamma is kept. Nodal velocities stay: momentum and kinetic energy carry over through the corner
  /// masses; what the lumping of former hanging nodes held more heats or is dropped (doc/theory/projection.md).
  ///
  /// The Eulerian halo must be up to date. Elements of the halo that the Eulerian view does not hold stay
  /// empty until the next exchange.
  /// @param names  of the materials, for messages
  /// @throws StateError if an owned element has no cell, if `f` of one exceeds 1 by more than 1e-10, or if open void
  ///         meets a material that can hold no voids (the Lagrangian stage needs a void law in every material).
  template <int dim>
  State<dim>
  to_lagrangian(const FlatMesh<dim> &cells, const State<dim> &eulerian, const FlatMesh<dim> &elements,
                const Boundaries<dim> &boundaries, KineticLoss loss, std::span<const std::string> names,
                TakenUp<dim> &taken_up);
} // namespace whipple
