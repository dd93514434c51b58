// SPDX-License-Identifier: LGPL-2.1-or-later
#pragma once

#include <whipple/mesh/flat_builder.h>
#include <whipple/state/packet_layout.h>

namespace whipple
{
  /// Refinement and coarsening of one cell as conservative remaps on packets (doc/theory/refinement.md).
  /// Mass, volume and internal energy of every material, momentum and total energy (corner kinetic energy plus
  /// the packet's kinetic remainder) are kept to round-off; a uniform velocity and uniform specific values
  /// keep their bits. Neither ever takes internal energy: kinetic energy that smoothing loses goes to the kinetic
  /// remainder, which gather_velocities() gives back to nodes or turns into heat; where restoring the
  /// momentum would make kinetic energy, the velocities' deviation from the mean is scaled down.
  ///
  /// Stateless after construction; split and merge may be called from anywhere.
  template <int dim>
  class CellSplit
  {
  public:
    using Children = typename PacketRemap<dim>::Children;

    CellSplit(const Lattice<dim> &lattice, CellPacketLayout<dim> layout);

    /// Cut the cell into its children along each material's own interface plane; where these planes would overfill
    /// a child, along parallel planes in the order of the materials. Volumes are true volumes. Children that
    /// get no material are empty.
    Children
    split(CellKey parent, const CellPacket &packet) const;

    /// Join children: extensive quantities add, specific ones are mass- or volume-weighted by their carrier,
    /// the outer corners' velocities stay up to a shift that restores the momentum.
    CellPacket
    merge(CellKey parent, const Children &children) const;

    /// Both, as the forest takes them; holds a copy of this object.
    PacketRemap<dim>
    packet_remap() const;

  private:
    Lattice<dim>          lattice_;
    CellPacketLayout<dim> layout_;
  };
} // namespace whipple
