// SPDX-License-Identifier: LGPL-2.1-or-later
#pragma once

#include <whipple/mesh/cell_packet.h>
#include <whipple/state/corner_velocity.h>
#include <whipple/state/fields.h>

#include <span>
#include <vector>

namespace whipple
{
  /// Out-of-material unit normals of the interfaces, [material][axis][cell]; zero where a cell is full or
  /// empty of the material (remap/interface_normal.h).
  template <int dim>
  using InterfaceNormals = std::vector<std::array<std::vector<double>, dim>>;

  /// Where things sit in the packet of a cell (CellPacket), the same on all ranks of a run:
  ///
  ///     corner velocities   dim * corners   [axis][corner], cm/us
  ///     kinetic remainder   1               Mbar cm^3, see CornerVelocities
  ///     for each material   volume, mass, density, energy, phi, normal (dim), carried fields
  ///
  /// An empty vector stands for a cell without material.
  template <int dim>
  struct CellPacketLayout
  {
    static constexpr int corners = 1 << dim;

    std::vector<bool>    has_voids; ///< per material; without voids phi travels as 0
    std::vector<Carrier> carrier;   ///< of the carried fields, the same list in every material

    /// The layout of a state's cells.
    static CellPacketLayout
    of(const State<dim> &state);

    int
    n_materials() const
    {
      return static_cast<int>(has_voids.size());
    }
    int
    n_fields() const
    {
      return static_cast<int>(carrier.size());
    }
    static constexpr int
    velocity(int axis, int corner)
    {
      return axis * corners + corner;
    }
    static constexpr int
    kinetic_remainder()
    {
      return dim * corners;
    }
    int
    volume(int material) const
    {
      return dim * corners + 1 + material * (5 + dim + n_fields());
    }
    int
    mass(int material) const
    {
      return volume(material) + 1;
    }
    int
    density(int material) const
    {
      return volume(material) + 2;
    }
    int
    energy(int material) const
    {
      return volume(material) + 3;
    }
    int
    void_fraction(int material) const
    {
      return volume(material) + 4;
    }
    int
    normal(int material, int axis) const
    {
      return volume(material) + 5 + axis;
    }
    int
    field(int material, int field) const
    {
      return volume(material) + 5 + dim + field;
    }
    /// Number of doubles in a packet that is not empty.
    int
    size() const
    {
      return volume(n_materials());
    }
  };

  /// Volume of solid in a cell, sum of (1 - phi) V over its materials, cm^3.
  template <int dim>
  double
  solid_volume(const CellPacketLayout<dim> &layout, const CellPacket &packet)
  {
    double solid = 0;
    for (int m = 0; m < layout.n_materials(); ++m)
      solid += packet[layout.volume(m)] * (1. - packet[layout.void_fraction(m)]);
    return solid;
  }

  /// The packet of one cell; empty when it holds no material.
  /// @param velocities  corner_velocities() of the state
  /// @param normals     of this state, per material
  template <int dim>
  CellPacket
  pack(const CellPacketLayout<dim> &layout, const State<dim> &state, Index cell,
       const CornerVelocities<dim> &velocities, const InterfaceNormals<dim> &normals);

  /// Write a packet into a cell of a state whose material arrays are sized; an empty packet (or one that is
  /// not there) zeroes the cell. Pressure and sound speed are not carried: the stage evaluates them.
  /// @throws StateError if the packet is neither empty nor of the layout's size.
  template <int dim>
  void
  unpack(const CellPacketLayout<dim> &layout, std::span<const double> packet, State<dim> &state, Index cell,
         CornerVelocities<dim> &velocities);

  /// A state sized for `mesh` at its undeformed positions: true volumes, corner weights, zero
  /// material with the same materials, voids and fields as `like`, zero velocity and node mass; time and
  /// field index copied.
  template <int dim>
  State<dim>
  empty_state_like(const State<dim> &like, const FlatMesh<dim> &mesh);
} // namespace whipple
