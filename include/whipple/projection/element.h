// SPDX-License-Identifier: LGPL-2.1-or-later
#pragma once

#include <whipple/mesh/flat_mesh.h>
#include <whipple/state/conserved_totals.h>
#include <whipple/state/fields.h>
#include <whipple/state/packet_layout.h>

#include <mpi.h>

#include <limits>
#include <vector>

namespace whipple
{
  /// A Lagrangian element on its way to an Eulerian mesh: where its corners are, what they weigh, and what it holds.
  template <int dim>
  struct Element
  {
    static constexpr int corners = 1 << dim;

    CellKey                                      key = 0;       ///< orders elements, the same on all ranks
    std::array<std::array<double, corners>, dim> position{};    ///< cm
    std::array<double, corners>                  corner_mass{}; ///< g
    CellPacket                                   packet;        ///< velocities, materials; normals unused
    long piece = -1; ///< number of the solid piece that it is a part of, if it is (form_fragments); < 0: none
    /// cm; a piece that is a ring is solid while its radius is smaller, farther out its section stays and void opens
    double solid_within = std::numeric_limits<double>::infinity();
  };

  /// The owned elements of a Lagrangian state that hold material, in the order of the mesh.
  template <int dim>
  std::vector<Element<dim>>
  elements_of(const CellPacketLayout<dim> &layout, const FlatMesh<dim> &mesh, const State<dim> &state);

  /// All ranks' elements on every rank, ordered by key. Collective.
  template <int dim>
  std::vector<Element<dim>>
  gather_elements(MPI_Comm communicator, const CellPacketLayout<dim> &layout, const std::vector<Element<dim>> &mine);

  /// Mass, momentum and energies of an element (kinetic: corner masses plus remainder).
  template <int dim>
  ConservedTotals<dim>
  totals_of(const CellPacketLayout<dim> &layout, const Element<dim> &element);
} // namespace whipple
