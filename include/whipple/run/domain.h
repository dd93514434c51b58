// SPDX-License-Identifier: LGPL-2.1-or-later
#pragma once

#include <whipple/mesh/forest.h>
#include <whipple/problem/field_layout.h>
#include <whipple/state/bookings.h>
#include <whipple/state/derived.h>
#include <whipple/state/packet_layout.h>

#include <memory>
#include <vector>

namespace whipple
{
  /// Where a run stands: the forest over the scene, the flat view of its active part, and the state on it.
  /// The view lives on the heap because halo and kernels keep its address; what was a view stays as it was.
  template <int dim>
  struct Domain
  {
    Forest<dim>                               forest;
    std::shared_ptr<const FlatPartition<dim>> view;
    State<dim>                                state;
    Derived derived{}; ///< of this state whenever a step begins or ends; of none while it is handed over

    MPI_Comm
    communicator() const
    {
      return forest.communicator();
    }
  };

  /// A state without material on the present view, at undeformed positions; the time stays.
  template <int dim>
  void
  clear_state(const FieldLayout &layout, Domain<dim> &domain);

  /// Fill a cleared state from the packets of this rank's leaves: cells, halo, then nodes. Collective.
  /// @returns what the averaging of velocities lost and the walls took, all ranks
  template <int dim>
  Booking<dim>
  unpack_leaves(const FieldLayout &fields, const CellPacketLayout<dim> &layout, const std::vector<CellPacket> &packets,
                const Boundaries<dim> &boundaries, KineticLoss loss, Domain<dim> &domain);

  /// Bring the cells' contents of a state up to date in the halo.
  template <int dim>
  void
  exchange_cells(const FieldLayout &layout, const Halo<dim> &halo, State<dim> &state);

  /// Bring corner velocities and kinetic remainders up to date in the halo.
  template <int dim>
  void
  exchange_corners(const Halo<dim> &halo, CornerVelocities<dim> &corners);
} // namespace whipple
