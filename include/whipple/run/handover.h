// SPDX-License-Identifier: LGPL-2.1-or-later
#pragma once

#include <whipple/ledger/ledger.h>
#include <whipple/problem/problem.h>
#include <whipple/projection/element.h>
#include <whipple/run/regridding.h>

namespace whipple
{
  /// How one stage hands its material to the next: the projections, with all bookkeeping.
  template <int dim>
  class Handover
  {
  public:
    Handover(const Problem<dim> &problem, const Regridding<dim> &regridding);

    /// Make the domain ready for a stage: bodies that enter are painted, projections run where the mode changes.
    /// @param previous the stage before, null for the first
    void
    enter(const Stage &stage, const Stage *previous, Domain<dim> &domain, Ledger<dim> &ledger) const;

    /// Lay the elements of a Lagrangian stage down on a fixed mesh and take them up again at once (rezone): pieces that
    /// have run into one another lie side by side afterwards. Elements beyond the domain leave it.
    /// @returns false, and nothing has happened, if all their solid does not fit into the domain
    bool
    lay_anew(const Stage &stage, Domain<dim> &domain, Ledger<dim> &ledger) const;

  private:
    /// Empty forest: mesh around the bodies, bodies into it.
    void
    start(const Stage &stage, Domain<dim> &domain, Ledger<dim> &ledger) const;

    /// A new Eulerian mesh around elements and entering bodies, without contents.
    /// @param buffer cells of an element's level around it
    void
    build_around(const std::vector<Element<dim>> &elements, const CellPacketLayout<dim> &layout, const Stage &stage,
                 int buffer, Domain<dim> &domain) const;

    /// Elements and entering bodies onto a new Eulerian mesh.
    /// @param sliver less than this share of an empty cell joins a neighbour
    void
    lay_down(const Stage &stage, double sliver, Domain<dim> &domain, Ledger<dim> &ledger) const;

    /// Cells become elements; of an Eulerian stage's material only the debris goes on, the rest is dropped.
    void
    take_up(const Stage &stage, bool select, Domain<dim> &domain, Ledger<dim> &ledger) const;

    /// Spread elements that are where their cells were evenly over the ranks: the partition is that of the cells, most
    /// of which have gone. Bits do not change.
    void
    spread(const Stage &stage, Domain<dim> &domain, Ledger<dim> &ledger) const;

    void
    paint(const Stage &stage, Domain<dim> &domain, Ledger<dim> &ledger) const;

    const Problem<dim>    &problem_;
    const Scene<dim>      &scene_;
    const FieldLayout     &layout_;
    const Regridding<dim> &regridding_;
  };
} // namespace whipple
