// SPDX-License-Identifier: LGPL-2.1-or-later
#pragma once

#include <whipple/mesh/cell_packet.h>
#include <whipple/mesh/flat_partition.h>

#include <mpi.h>

#include <cstdint>
#include <functional>
#include <memory>
#include <span>
#include <vector>

namespace whipple
{
  /// Work that a leaf stands for, from its packet: what the partition balances. At least 1 for an empty leaf.
  using LeafWeight = std::function<unsigned int(const CellPacket &packet)>;

  /// The forest of quadtrees (octrees) over the whole scene, distributed over the ranks along a space-filling
  /// curve: topology only, on the undeformed lattice. What the leaves hold travels as packets.
  ///
  /// The set of leaves depends on the targets alone, never on the number of ranks (doc/theory/mesh.md).
  template <int dim>
  class Forest
  {
  public:
    /// All leaves are root cells. Collective, as everything that is not const.
    /// @throws InputError if the lattice's coordinates do not fit into cell keys.
    Forest(MPI_Comm communicator, const Lattice<dim> &lattice);
    ~Forest();

    /// This rank's leaves in forest order.
    std::span<const CellKey>
    leaves() const;

    /// All leaves of all ranks in forest order, the same on every rank and for every number of ranks.
    std::span<const CellKey>
    all_leaves() const;

    /// Where this rank's leaves begin among all of them.
    std::size_t
    first_leaf() const;

    const Lattice<dim> &
    lattice() const;

    MPI_Comm
    communicator() const;

    /// One round: every leaf moves by at most one level towards its target, as far as 2:1 balance over faces
    /// and corners allows (agree_levels). Packets are split, merged and moved with their leaves, and the forest is
    /// partitioned anew by weight. Does nothing if no leaf changes anywhere.
    /// @param target wanted level of each leaf of leaves()
    /// @param packets one for each leaf of leaves(), before and after; empty ones are not shown to `remap`
    /// @param weight called before the move, once per leaf that will be; equal weights if there is none
    /// @returns whether any leaf changed on any rank
    /// @throws StateError if lengths do not match leaves(), a target exceeds max_level, or the mesh that
    ///         results is not the one agreed on.
    bool
    adapt(std::span<const std::uint8_t> target, std::vector<CellPacket> &packets, const PacketRemap<dim> &remap,
          const LeafWeight &weight = {});

    /// Rounds of adapt() until nothing changes. `target_level` is asked for every leaf in every round.
    /// @returns number of rounds that changed the mesh
    int
    adapt_until(const std::function<std::uint8_t(CellKey leaf)> &target_level, std::vector<CellPacket> &packets,
                const PacketRemap<dim> &remap, const LeafWeight &weight = {});

    /// Partition anew by weight; leaves stay, packets move with them.
    void
    repartition(std::vector<CellPacket> &packets, const LeafWeight &weight);

    /// The active leaves as flat arrays (flatten_leaves).
    /// @param active one entry for each leaf of leaves()
    /// @param bonds  uniform, or one entry for each leaf of leaves()
    std::unique_ptr<FlatPartition<dim>>
    flatten(const std::vector<std::uint8_t> &active, int halo_width, const Bonds &bonds) const;

  private:
    class Implementation;
    std::unique_ptr<Implementation> implementation_;
  };
} // namespace whipple
