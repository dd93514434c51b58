// SPDX-License-Identifier: LGPL-2.1-or-later
#pragma once

#include <whipple/mesh/index.h>
#include <whipple/state/conserved_totals.h>
#include <whipple/state/exact_sum.h>

#include <array>

namespace whipple
{
  /// Conserved amounts being summed exactly: the same bits in any order and on any number of ranks.
  template <int dim>
  struct ExactTotals
  {
    std::array<ExactSum, 3 + dim> sum; ///< mass, internal and kinetic energy, momentum

    void
    add(const ConservedTotals<dim> &amounts)
    {
      sum[0].add(amounts.mass);
      sum[1].add(amounts.internal_energy);
      sum[2].add(amounts.kinetic_energy);
      for (int d = 0; d < dim; ++d)
        sum[3 + d].add(amounts.momentum[d]);
    }

    /// Momentum and kinetic energy of a mass that moves; not the mass itself.
    void
    add_corner(double mass, const Vector<dim> &velocity)
    {
      double square = 0;
      for (int d = 0; d < dim; ++d)
        {
          square += velocity[d] * velocity[d];
          sum[3 + d].add(mass * velocity[d]);
        }
      sum[2].add(0.5 * mass * square);
    }

    ConservedTotals<dim>
    amounts() const
    {
      ConservedTotals<dim> result;
      result.mass            = sum[0].value();
      result.internal_energy = sum[1].value();
      result.kinetic_energy  = sum[2].value();
      for (int d = 0; d < dim; ++d)
        result.momentum[d] = sum[3 + d].value();
      return result;
    }
  };
} // namespace whipple
