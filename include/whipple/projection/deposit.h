// SPDX-License-Identifier: LGPL-2.1-or-later
#pragma once

#include <whipple/projection/cell_motion.h>
#include <whipple/projection/cell_tree.h>
#include <whipple/projection/element_pieces.h>
#include <whipple/projection/laid.h>
#include <whipple/projection/overfull_cell.h>
#include <whipple/state/corner_velocity.h>

#include <vector>

namespace whipple::projection
{
  /// Elements on their way into the cells of one rank: what comes is kept apart, materials and motion, until what does
  /// not fit has been spread; finish() adds the materials to the state and makes corner velocities of the motion.
  class Deposit
  {
  public:
    /// @param state  what the cells already hold; corner velocities are taken from its nodes
    Deposit(const Lattice<2> &lattice, const CellPacketLayout<2> &layout, const FlatMesh<2> &mesh, State<2> &state);

    /// Clip one element to all cells it meets.
    /// @throws StateError if it brings voids to a material whose state has none.
    void
    lay_down(const Element<2> &element, const ElementPieces &pieces);

    /// Mass laid down on owned cells so far, g.
    double
    owned_mass() const;

    /// What has been laid down so far, of owned and halo cells.
    Laid &
    laid()
    {
      return laid_;
    }

    /// Add what was laid down to the state (as it is: cells may be overfull then).
    /// @returns corner velocities of what was there and what came, with the kinetic energy that they do not show as
    /// remainder: per cell u_k = mean u + L (x_k - mean x_corners), L the least-squares gradient of the
    /// debris, scaled down where it would move the corners more vigorously than the debris moved.
    CornerVelocities<2>
    finish();

  private:
    void
    add_materials(const Element<2> &element, const ElementPieces &pieces, double share, Index cell);

    std::array<Vector<2>, 4>
    debris_corners(Index cell, const std::array<double, 4> &shares, double &remainder) const;

    CellPacketLayout<2> layout_;
    Symmetry            symmetry_;
    const FlatMesh<2>  &mesh_;
    State<2>           &state_;
    CellTree<2>         tree_;
    CornerVelocities<2> existing_;
    std::vector<double> existing_mass_; ///< [n_cells] g
    Laid                laid_;
  };

  /// What of an element lies beyond the domain's sides; zero, not round-off, for one inside.
  ConservedTotals<2>
  beyond_domain(const Lattice<2> &lattice, const CellPacketLayout<2> &layout, const Element<2> &element,
                const ElementPieces &pieces);
} // namespace whipple::projection
