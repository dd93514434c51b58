// SPDX-License-Identifier: LGPL-2.1-or-later
#pragma once

#include <whipple/mesh/halo.h>
#include <whipple/projection/laid.h>
#include <whipple/state/booking.h>

#include <mpi.h>

namespace whipple::projection
{
  /// Give what was laid down in cells of which it fills less than a share, where nothing was before, to the face
  /// neighbour that holds the most solid, if that is more than the cell's own and has room for a hundredth of its
  /// volume (so nothing is squeezed). A cell that is to become an element needs enough in it to have a state of its
  /// own. Conserves as spread_excess does. Collective; same bits on any number of ranks.
  /// @returns cells given up by all ranks, and the mass in them
  Event
  gather_slivers(MPI_Comm communicator, const FlatMesh<2> &mesh, const Halo<2> &halo, const State<2> &state,
                 double share, Laid &laid);
} // namespace whipple::projection
