// SPDX-License-Identifier: LGPL-2.1-or-later
#pragma once

#include <whipple/mesh/flat_mesh.h>
#include <whipple/projection/waiting_debris.h>
#include <whipple/state/conserved_totals.h>
#include <whipple/state/fields.h>

#include <mpi.h>

#include <functional>
#include <vector>

namespace whipple
{
  /// What the cells of all ranks hold: mass and internal energy of the cells, momentum and kinetic energy of
  /// the nodes (sum of m v^2 / 2 over the nodes that do not hang). Same bits on any number of ranks.
  template <int dim>
  ConservedTotals<dim>
  totals(const FlatMesh<dim> &mesh, const State<dim> &state, MPI_Comm communicator);

  /// What the owned cells of all ranks for which `belongs` holds contain, by corner masses. Same bits on any number of
  /// ranks.
  template <int dim>
  ConservedTotals<dim>
  cell_sum(const FlatMesh<dim> &mesh, const State<dim> &state, const std::function<bool(Index cell)> &belongs,
           MPI_Comm communicator);

  /// The same split by body: each body's part of a cell's mass, internal energy and corner momenta; its
  /// kinetic energy is that of the corner masses at the nodes' velocities.
  /// @param tag index of each body's field "mass fraction of body", -1 for what the other tags leave.
  template <int dim>
  std::vector<ConservedTotals<dim>>
  body_totals(const FlatMesh<dim> &mesh, const State<dim> &state, const std::vector<int> &tag,
              const std::vector<Index> &material, MPI_Comm communicator);

  /// What waiting debris holds, by its corner masses.
  template <int dim>
  ConservedTotals<dim>
  totals(const CellPacketLayout<dim> &layout, const std::vector<Waiting<dim>> &parts);

  /// The same split by body, as the cells' contents are.
  template <int dim>
  std::vector<ConservedTotals<dim>>
  body_totals(const CellPacketLayout<dim> &layout, const std::vector<Waiting<dim>> &parts, const std::vector<int> &tag,
              const std::vector<Index> &material);
} // namespace whipple
