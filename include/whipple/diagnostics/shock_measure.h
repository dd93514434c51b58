// SPDX-License-Identifier: LGPL-2.1-or-later
#pragma once

#include <whipple/mesh/flat_mesh.h>
#include <whipple/problem/problem.h>
#include <whipple/state/fields.h>

#include <mpi.h>

#include <optional>

namespace whipple
{
  /// Where the shock of an exact solution is in the field, as profile coordinates, cm.
  struct ShockMeasure
  {
    double                exact = 0; ///< where it should be
    std::optional<double> mean;      ///< of the three rays, as far as the shock is found on them
    std::optional<double> spread;    ///< largest minus smallest of the three
  };

  /// Measure along three rays: a radial profile along the axis (axis 1), at 45 degrees and along the equator (axis 0);
  /// any other along its coordinate near both sides of the domain and midway. On a ray the cells that it meets are
  /// ordered by the profile coordinate of their middles; the shock is where their density, linear between them,
  /// crosses the mean of the exact densities on both sides of the exact shock, nearest to it. Collective.
  /// @returns nothing if the solution has no shock or does not say the densities beside it
  template <int dim>
  std::optional<ShockMeasure>
  measure_shock(const Problem<dim> &problem, const FlatMesh<dim> &mesh, const State<dim> &state, MPI_Comm communicator);
} // namespace whipple
