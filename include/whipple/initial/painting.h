// SPDX-License-Identifier: LGPL-2.1-or-later
#pragma once

#include <whipple/mesh/refinement_map.h>
#include <whipple/problem/level_need.h>
#include <whipple/problem/problem.h>
#include <whipple/state/velocity_gather.h>

#include <span>

namespace whipple
{
  /// Ask for the level that they need wherever these bodies are, and for the finest around energy deposits.
  /// @param need what level what needs; null: the finest everywhere, for a mesh that no regrid will follow
  template <int dim>
  void
  request_bodies(const Scene<dim> &scene, const LevelNeed<dim> *need, std::span<const std::size_t> bodies,
                 RefinementMap<dim> &map);

  /// Put bodies into the cells of a state, beside what they hold already: exact true volumes of the cut cells (what is
  /// below round_off_share of a cell stays out),
  /// density, energy and velocity of each body, uniform or those of the scene's exact solution; then make nodes of the
  /// corner velocities (where bodies of different velocity share a node, momentum is kept and the kinetic energy lost
  /// heats the cells). Energy deposits are added to the leaf that holds their point.
  /// @throws StateError if a deposit finds no material, or the exact solution gives no initial state;
  /// ConservationError if the cells do not receive the volumes of the bodies.
  template <int dim>
  Booking<dim>
  paint_bodies(const Problem<dim> &problem, std::span<const std::size_t> bodies, const FlatMesh<dim> &mesh,
               MPI_Comm communicator, State<dim> &state);
} // namespace whipple
