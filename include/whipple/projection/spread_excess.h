// SPDX-License-Identifier: LGPL-2.1-or-later
#pragma once

#include <whipple/error.h>
#include <whipple/mesh/halo.h>
#include <whipple/projection/laid.h>
#include <whipple/state/booking.h>

#include <mpi.h>

#include <cstdint>
#include <span>

namespace whipple
{
  /// Solid that was laid down finds no room in the active cells around it; a mesh with more of them may help.
  class NoRoomError : public StateError
  {
  public:
    using StateError::StateError;
  };
} // namespace whipple

namespace whipple::projection
{
  /// What spreading did, over all ranks.
  struct SpreadReport
  {
    Event  moved{0, 0, "cm^3"}; ///< cells that held more solid than fits, and the volume of what did not fit there
    double pores_squeezed = 0;  ///< void pressed out of what lay in those cells, cm^3
    double depth          = 0;  ///< largest volume of solid in a cell over the cell's volume; 0 if none was overfull
    int    rounds         = 0;  ///< of handing over to neighbours
  };

  /// Solid beyond this part of its cell's volume is moved; what is less is round-off and stays.
  inline constexpr double excess_tolerance = 1e-6;

  /// Move solid that does not fit into its cell to where there is room, as a pile of sand falls apart
  /// (doc/theory/projection.md): nothing is compressed, so no work is done. A cell that holds more solid than its
  /// volume loses the pores of what was laid down there and hands the excess share of it, all materials alike, to the
  /// face neighbours that have room, in proportion to it; if none has, to those from which the way to room is shortest
  /// (cells that were full before count as far). Mass, volume of solid, internal energy, momentum and kinetic energy
  /// (as Motion counts it: that of the mean velocities plus that about them) are kept. What the cells held already
  /// stays. Collective; same bits on any number of ranks.
  /// @param state  what the cells hold already; not changed
  /// @param closed cells that may not be filled further, a flag each; empty: none. The halo's must be the owners'.
  /// @param laid   of owned and halo cells; the halo is up to date afterwards
  /// @throws NoRoomError if the reachable cells are full
  SpreadReport
  spread_excess(MPI_Comm communicator, const FlatMesh<2> &mesh, const Halo<2> &halo, const State<2> &state,
                std::span<const std::uint8_t> closed, Laid &laid);
} // namespace whipple::projection
