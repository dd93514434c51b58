// SPDX-License-Identifier: LGPL-2.1-or-later
#pragma once

#include <whipple/projection/intact_cells.h>
#include <whipple/run/domain.h>

#include <span>

namespace whipple
{
  /// Break the bonds of elements, where they are: every corner of a broken cell becomes a
  /// node of its own with the position and velocity of the node it was part of, and so do the parts a node falls into.
  /// Cells, their order and the partition stay. Mass and momentum are kept to the last bit of the corner masses;
  /// kinetic energy changes only at hanging nodes that come free (gather_velocities). What has broken stays so.
  /// Collective. Without newly broken cells on any rank nothing happens, and the view stays the same object.
  /// @param freed owned cells; those that have broken already may be among them
  /// @param bookings of all ranks, "broken bonds" is added
  /// @returns cells of all ranks that broke
  template <int dim>
  long
  free_cells(std::span<const Index> freed, const Boundaries<dim> &boundaries, KineticLoss loss, Domain<dim> &domain,
             Bookings<dim> &bookings);

  /// Break the bonds of the elements that are intact no longer by the criteria, in the same way.
  template <int dim>
  long
  break_bonds(const BreakCriteria &criteria, const Boundaries<dim> &boundaries, KineticLoss loss, Domain<dim> &domain,
              Bookings<dim> &bookings);
} // namespace whipple
