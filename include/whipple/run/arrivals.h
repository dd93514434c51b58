// SPDX-License-Identifier: LGPL-2.1-or-later
#pragma once

#include <whipple/hydro/fragment_release.h>
#include <whipple/mesh/flat_mesh.h>
#include <whipple/projection/waiting_debris.h>
#include <whipple/scene/scene.h>
#include <whipple/state/fields.h>

#include <mpi.h>

#include <cstdint>
#include <vector>

/// Which of the debris that waits has come: doc/theory/stages.md, "Streaming hand-over".
namespace whipple
{
  /// Time between two looks, us: the fastest flies 16 finest cells.
  double
  time_between_looks(const Scene<2> &scene, const WaitingDebris<2> &waiting);

  /// Parts of `waiting` that are to be laid down at `state.time`, a flag each, those of a piece together. Collective,
  /// the same on all ranks and on any number of them.
  /// @param walls reflecting sides
  std::vector<std::uint8_t>
  find_arrivals(const Scene<2> &scene, const CellPacketLayout<2> &layout, const WaitingDebris<2> &waiting,
                const RigidWalls<2> &walls, const FlatMesh<2> &mesh, const State<2> &state, MPI_Comm communicator);

  /// Parts of `waiting` that fly on through the plane [cm] across axis 1 without meeting what the mesh holds, a flag
  /// each. Collective, the same on all ranks.
  std::vector<std::uint8_t>
  find_passing(const Scene<2> &scene, const CellPacketLayout<2> &layout, const WaitingDebris<2> &waiting,
               const FlatMesh<2> &mesh, const State<2> &state, double plane, MPI_Comm communicator);

  /// Momentum along axis 1, g cm/us, of what waits, is faster along it than `velocity` and will come to the plane
  /// `face` [cm] across it, within the domain.
  double
  momentum_that_comes(const Scene<2> &scene, const CellPacketLayout<2> &layout, const WaitingDebris<2> &waiting,
                      double time, double face, double velocity);
} // namespace whipple
