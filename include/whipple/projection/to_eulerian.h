// SPDX-License-Identifier: LGPL-2.1-or-later
#pragma once

#include <whipple/mesh/boundary.h>
#include <whipple/mesh/flat_builder.h>
#include <whipple/projection/element.h>
#include <whipple/projection/gather_slivers.h>
#include <whipple/projection/representation.h>
#include <whipple/projection/spread_excess.h>
#include <whipple/state/bookings.h>
#include <whipple/state/conserved_totals.h>

#include <mpi.h>

#include <span>
#include <vector>

namespace whipple
{
  /// What cells may take up.
  struct LayDownLimits
  {
    std::span<const std::uint8_t> closed;     ///< cells that take up nothing that has to be spread; empty: none
    double                        sliver = 0; ///< less than this share of an empty cell joins a neighbour
  };

  /// What a projection onto cells did, over all ranks.
  template <int dim>
  struct LaidDown
  {
    ConservedTotals<dim> elements;           ///< what was to be laid down
    double               pores_squeezed = 0; ///< cm^3 of void pressed out where cells were overfull
    double        solid_compressed      = 0; ///< cm^3 of solid beyond the cells' volume, round-off: it is denser for it
    Bookings<dim> bookings;
  };

  /// The causes in it.
  namespace laid_down
  {
    inline constexpr const char *projection = "projection"; ///< nodes made of the velocities of what was laid down
    inline constexpr const char *beyond     = "elements laid down beyond the domain";
    inline constexpr const char *spread     = "overlapping pieces laid down, solid moved to where there is room";
    inline constexpr const char *pressed    = "voids pressed out where what was laid down overlaps";
    inline constexpr const char *slivers    = "slivers joined to a neighbour as all was laid anew";
    inline constexpr const char *folded     = "folded elements laid down";
    inline constexpr const char *mirrored   = "corners beyond the axis laid down as their mirror image";
  } // namespace laid_down

  /// Lagrangian -> Eulerian: lay elements down on the cells of a mesh, on top of what the state already holds there
  /// (a painted wall). Mass, momentum and total energy are kept to round-off; a uniform velocity stays uniform.
  /// Overfull cells first lose voids at constant gamma; solid that still does not fit is spread to where there is room
  /// (spread_excess.h), never squeezed. The halo of the state must be up to date before, and is afterwards but for
  /// its outermost layer of nodes. Collective.
  /// @param elements  all ranks' (gather_elements), ordered by key, as the representation has gathered them
  /// @param state     holds what is already there, in Eulerian form (corner weights of the undeformed cells)
  /// @throws StateError if an element has no volume or mass, NoRoomError if the cells cannot hold the solid (the state
  ///         is as it was), or ConservationError if the mesh does not cover
  ///         all of the elements that lie inside the domain (relative mass beyond 1e-11).
  template <int dim>
  LaidDown<dim>
  to_eulerian(MPI_Comm communicator, const Lattice<dim> &lattice, const CellPacketLayout<dim> &layout,
              const std::vector<Element<dim>> &elements, const Representation &representation,
              const FlatMesh<dim> &mesh, const Halo<dim> &halo, const LayDownLimits &limits,
              const Boundaries<dim> &boundaries, KineticLoss loss, State<dim> &state);

  /// The cells of the lattice at `level` that elements touch once laid down, for building the mesh.
  /// Sorted; cells outside the domain left out.
  template <int dim>
  std::vector<CellKey>
  touched_cells(const Lattice<dim> &lattice, const std::vector<Element<dim>> &elements, int level);
} // namespace whipple
