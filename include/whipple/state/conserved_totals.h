// SPDX-License-Identifier: LGPL-2.1-or-later
#pragma once

#include <whipple/mesh/index.h>

namespace whipple
{
  /// What a ledger counts of some material: g, g cm/us, Mbar cm^3.
  template <int dim>
  struct ConservedTotals
  {
    double      mass = 0;
    Vector<dim> momentum{};
    double      internal_energy = 0;
    double      kinetic_energy  = 0;

    double
    total_energy() const
    {
      return internal_energy + kinetic_energy;
    }

    ConservedTotals &
    operator+=(const ConservedTotals &other)
    {
      mass += other.mass;
      for (int d = 0; d < dim; ++d)
        momentum[d] += other.momentum[d];
      internal_energy += other.internal_energy;
      kinetic_energy += other.kinetic_energy;
      return *this;
    }
  };
} // namespace whipple
