// SPDX-License-Identifier: LGPL-2.1-or-later
#pragma once

#include <whipple/mesh/index.h>
#include <whipple/state/bookings.h>
#include <whipple/state/exact_sum.h>

#include <array>

namespace whipple
{
  /// What crossed one side of the domain outwards (inwards: negative).
  template <int dim>
  struct SideFlux
  {
    double      mass = 0;     ///< g
    Vector<dim> momentum{};   ///< g cm/us; includes what a wall took from nodes that cannot move into it
    double      kinetic  = 0; ///< Mbar cm^3
    double      internal = 0; ///< Mbar cm^3
  };

  /// Sums of remap sweeps over this rank's owned cells; bookings() is how they go into the ledger. Added up over sweeps
  /// and ranks they are global totals:  kinetic_after = kinetic_before - kinetic_lost - sum of sides' kinetic,
  /// internal_after = internal_before + kinetic_heated - sum of sides' internal.
  template <int dim>
  struct RemapSums
  {
    std::array<SideFlux<dim>, 2 * dim> side{};             ///< 2 * axis + {0 lower, 1 upper}
    double                             kinetic_lost   = 0; ///< by mixing momentum, Mbar cm^3
    double                             kinetic_heated = 0; ///< part of kinetic_lost given to internal energy, Mbar cm^3
    ExactSum                           remnant_mass;       ///< given away by donors left almost empty, g
    Index                              remnant_cells = 0;
    ExactSum                           compressed;           ///< volume by which overfull cells were cut back, cm^3
    Index                              cells_compressed = 0; ///< by more than a millionth of the cell

    RemapSums &
    operator+=(const RemapSums &other)
    {
      for (int s = 0; s < 2 * dim; ++s)
        {
          side[s].mass += other.side[s].mass;
          side[s].kinetic += other.side[s].kinetic;
          side[s].internal += other.side[s].internal;
          for (int d = 0; d < dim; ++d)
            side[s].momentum[d] += other.side[s].momentum[d];
        }
      kinetic_lost += other.kinetic_lost;
      kinetic_heated += other.kinetic_heated;
      remnant_mass.add(other.remnant_mass);
      remnant_cells += other.remnant_cells;
      compressed.add(other.compressed);
      cells_compressed += other.cells_compressed;
      return *this;
    }

    /// Bring the exact sums of all ranks to the first, the others keep none: adding up the ranks' bookings gives the
    /// same bits on any number of them then. Collective.
    void
    collect(MPI_Comm communicator);

    Bookings<dim>
    bookings(KineticLoss loss) const;
  };
} // namespace whipple
