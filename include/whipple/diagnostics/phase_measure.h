// SPDX-License-Identifier: LGPL-2.1-or-later
#pragma once

#include <whipple/mesh/flat_mesh.h>
#include <whipple/output/snapshot.h>
#include <whipple/problem/field_layout.h>

#include <mpi.h>

#include <vector>

namespace whipple
{
  /// How hot the materials are that the effect "melting" knows, by mass.
  struct PhaseMeasure
  {
    double mass             = 0; ///< g of those materials
    double melt_share       = 0; ///< mass share of melt and vapour
    double vapour_share     = 0; ///< mass share of vapour
    double mean_temperature = 0; ///< K
    double temperature_99   = 0; ///< K, 99 % of the mass is colder
  };

  /// Measure the owned cells of all ranks. Collective.
  template <int dim>
  PhaseMeasure
  measure_phases(const FieldLayout &layout, const FlatMesh<dim> &mesh, const State<dim> &state, MPI_Comm communicator);

  /// Temperature, melt and vapour fraction of every material that melts, for field files.
  template <int dim>
  std::vector<CellField>
  phase_fields(const FieldLayout &layout, const State<dim> &state, const std::vector<Index> &cells);
} // namespace whipple
