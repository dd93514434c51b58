// SPDX-License-Identifier: LGPL-2.1-or-later
#pragma once

#include <whipple/mesh/flat_mesh.h>
#include <whipple/problem/field_layout.h>
#include <whipple/projection/waiting_debris.h>
#include <whipple/state/fields.h>

#include <mpi.h>

#include <optional>
#include <vector>

namespace whipple
{
  /// What material has broken into (effect "fragment size"; doc/theory/measures.md, "Fragments").
  struct FragmentSizes
  {
    double number        = 0; ///< of fragments of all sizes
    double mean_size     = 0; ///< cm, by mass
    double unbroken_mass = 0; ///< g that has not broken

    /// Bins by size, cm: powers of 2, as many as there are sizes for. @{
    std::vector<double> edges, mass, number_of_bin; ///< cm, g, 1
    /// @}
  };

  /// Of the owned cells of all ranks and of debris that waits; none if nothing has broken. The same bits on any number
  /// of ranks. Collective.
  template <int dim>
  std::optional<FragmentSizes>
  measure_fragments(const FieldLayout &layout, const FlatMesh<dim> &mesh, const State<dim> &state,
                    MPI_Comm communicator, const WaitingDebris<dim> *waiting = nullptr);
} // namespace whipple
