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
  /// What a cloud holds, by a quantity of its cells (doc/theory/measures.md, "Debris by angle and velocity").
  template <int dim>
  struct Spectrum
  {
    std::vector<double>               edges; ///< ascending, one more than there are bins
    std::vector<ConservedTotals<dim>> bin;
  };

  /// A quantity of a cell: a function of what it holds, which is not nothing.
  template <int dim>
  using CellQuantity = std::function<double(const ConservedTotals<dim> &cell)>;

  /// Degrees from axis 1 to the momentum of a cell, 0 to 180; at rest: 0.
  template <int dim>
  double
  flight_angle(const ConservedTotals<dim> &cell);

  /// Momentum along axis 1 over mass, cm/us.
  template <int dim>
  double
  axial_velocity(const ConservedTotals<dim> &cell);

  /// Sums over the owned cells of all ranks that hold material, each whole in the bin that its quantity falls into;
  /// beyond the outermost edges in the outermost bins. Over all bins they are the state's totals, but for the rounding
  /// of each sum. The same bits on any number of ranks. Collective.
  /// @param edges ascending, two or more
  /// @param waiting debris that waits, the same on all ranks; its parts count like cells
  template <int dim>
  Spectrum<dim>
  spectrum(const FlatMesh<dim> &mesh, const State<dim> &state, std::vector<double> edges,
           const CellQuantity<dim> &quantity, MPI_Comm communicator, const WaitingDebris<dim> *waiting = nullptr);

  /// Edges of equal bins that hold the axial velocities of all cells, and 0: multiples of `width`, doubled until there
  /// are no more than 64 bins. Collective.
  /// @param width cm/us, > 0
  template <int dim>
  std::vector<double>
  velocity_edges(const FlatMesh<dim> &mesh, const State<dim> &state, double width, MPI_Comm communicator,
                 const WaitingDebris<dim> *waiting = nullptr);

  /// Edges of `bins` equal bins from `low` to `high`.
  std::vector<double>
  equal_edges(double low, double high, int bins);
} // namespace whipple
