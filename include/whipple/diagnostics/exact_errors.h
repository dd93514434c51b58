// SPDX-License-Identifier: LGPL-2.1-or-later
#pragma once

#include <whipple/exact/exact_solution.h>
#include <whipple/mesh/flat_mesh.h>
#include <whipple/output/summary.h>
#include <whipple/state/derived.h>
#include <whipple/state/fields.h>

#include <mpi.h>

#include <map>
#include <string>

namespace whipple
{
  /// Norms of the errors of a state against an exact solution at the state's time, weighted by true volume,
  ///
  ///     L1 = sum |e| V / sum V,   L2 = sqrt(sum e^2 V / sum V),   Linf = max |e|,
  ///
  /// and what they can be compared with, scale = sum |exact| V / sum V.
  ///
  /// "density" [g/cm^3] is mass over volume of the cell, "pressure" [Mbar] the mean over the cell's volume, "energy"
  /// [Mbar cm^3/g] that over its mass; each is compared with the exact mean over the cell where it is now. "velocity"
  /// [cm/us] is the length of the error vector of the nodes; each corner of a cell is weighted with its corner volume.
  ///
  /// A cell counts where the solution says so (ExactSolution::counts at its middle) and gives the quantity everywhere
  /// in it. Cells with open void count for the density alone; cells that are empty and that the solution leaves empty
  /// do not count. A quantity that counts nowhere is left out. Same bits on any number of ranks. Collective.
  template <int dim>
  std::map<std::string, summary::Error>
  exact_errors(const exact::ExactSolution<dim> &solution, const FlatMesh<dim> &mesh, const State<dim> &state,
               const Derived &derived, MPI_Comm communicator);
} // namespace whipple
