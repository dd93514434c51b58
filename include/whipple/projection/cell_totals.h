// SPDX-License-Identifier: LGPL-2.1-or-later
#pragma once

#include <whipple/state/conserved_totals.h>
#include <whipple/state/corner_velocity.h>
#include <whipple/state/fields.h>

namespace whipple
{
  /// Mass, momentum, internal and kinetic energy of a cell: kinetic energy of its corner masses plus the
  /// remainder. Over all cells they add up to the state's totals.
  /// @param velocities  corner_velocities() of the state
  template <int dim>
  ConservedTotals<dim>
  cell_totals(const State<dim> &state, const CornerVelocities<dim> &velocities, Index cell)
  {
    constexpr int        corners = 1 << dim;
    ConservedTotals<dim> totals;
    totals.mass = cell_mass<dim>(state, cell);
    for (const MaterialState &material : state.material)
      totals.internal_energy += material.mass[cell] * material.energy[cell];
    totals.kinetic_energy = velocities.kinetic_remainder[cell];
    const auto share      = corner_shares<dim>(state, cell);
    for (int k = 0; k < corners; ++k)
      for (int d = 0; d < dim; ++d)
        {
          const double u = velocities.velocity[d][cell * corners + k];
          totals.momentum[d] += share[k] * totals.mass * u;
          totals.kinetic_energy += 0.5 * share[k] * totals.mass * u * u;
        }
    return totals;
  }
} // namespace whipple
