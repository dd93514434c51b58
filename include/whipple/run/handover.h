// SPDX-License-Identifier: LGPL-2.1-or-later
#pragma once

#include <whipple/ledger/ledger.h>
#include <whipple/problem/problem.h>
#include <whipple/projection/debris_selection.h>
#include <whipple/projection/waiting_debris.h>
#include <whipple/run/regridding.h>

#include <functional>

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
    /// @param waiting  what is on its way and not in the domain; with `Hand-over = as it arrives` of an Eulerian stage
    ///                 after a Lagrangian one the elements that can wait
    void
    enter(const Stage &stage, const Stage *previous, Domain<dim> &domain, Ledger<dim> &ledger,
          SharedDebris<dim> &waiting) const;

    /// Lay the debris down that has come to what an Eulerian stage holds. Reads domain.derived; the mesh is another one
    /// then, and has no derived values. Collective.
    /// @returns whether there was any; if not, nothing has happened
    bool
    land_arrivals(const Stage &stage, Domain<dim> &domain, Ledger<dim> &ledger, SharedDebris<dim> &waiting) const;

    /// Lay the elements of a Lagrangian stage down on a fixed mesh and take them up again at once (rezone): pieces that
    /// have run into one another lie side by side afterwards. Elements beyond the domain leave it.
    /// @returns false, and nothing has happened, if all their solid does not fit into the domain
    bool
    lay_anew(const Stage &stage, Domain<dim> &domain, Ledger<dim> &ledger) const;

  private:
    /// Empty forest: mesh around the bodies, bodies into it.
    void
    start(const Stage &stage, Domain<dim> &domain, Ledger<dim> &ledger) const;

    /// The elements of all ranks as they are to be laid down in a stage.
    std::vector<Element<dim>>
    gather(const Stage &stage, const Domain<dim> &domain, Bookings<dim> &bookings) const;

    /// Let those wait that can. @returns the others
    std::vector<Element<dim>>
    let_wait(const Stage &stage, const Domain<dim> &domain, std::vector<Element<dim>> elements,
             SharedDebris<dim> &waiting) const;

    /// What waits, made of parts; null if there are none.
    SharedDebris<dim>
    waiting_of(const CellPacketLayout<dim> &layout, std::vector<Waiting<dim>> parts) const;

    /// Drop what waits and is no debris for a stage, by the criteria for its cells; what will fly through the plane of
    /// the criteria without meeting what the domain still holds is beyond it.
    void
    judge_waiting(const DebrisCriteria &criteria, const Domain<dim> &domain, Ledger<dim> &ledger,
                  SharedDebris<dim> &waiting) const;

    /// Ask for the levels that elements need.
    /// @param buffer cells of an element's level around it
    void
    request(const std::vector<Element<dim>> &elements, const CellPacketLayout<dim> &layout, int buffer,
            RefinementMap<dim> &map) const;

    /// A new Eulerian mesh around elements and entering bodies, without contents.
    /// @param buffer cells of an element's level around it
    void
    build_around(const std::vector<Element<dim>> &elements, const CellPacketLayout<dim> &layout, const Stage &stage,
                 int buffer, Domain<dim> &domain) const;

    /// Lay elements down on a mesh that has room for them: where pieces overlap, what does not fit needs room, and if
    /// the mesh around them has too little, one with more of it is made.
    /// @param make_mesh gives the domain a mesh, with so many cells around the elements, and all but them
    /// @returns what laying down has booked
    Bookings<dim>
    lay_where_there_is_room(const Stage &stage, const std::vector<Element<dim>> &elements,
                            const CellPacketLayout<dim> &layout, double sliver, Domain<dim> &domain,
                            const std::function<void(int buffer)> &make_mesh) const;

    /// Elements and entering bodies onto a new Eulerian mesh.
    /// @param sliver   less than this share of an empty cell joins a neighbour
    /// @param gathered what gathering them has booked
    void
    lay_down(const Stage &stage, const std::vector<Element<dim>> &elements, double sliver,
             const Bookings<dim> &gathered, Domain<dim> &domain, Ledger<dim> &ledger) const;

    /// Which cells of an Eulerian stage are debris for a Lagrangian one.
    DebrisCriteria
    debris_criteria(const LagrangianStage &stage, bool select) const;

    /// Cells become elements; of an Eulerian stage's material only the debris goes on, the rest is dropped.
    void
    take_up(const Stage &stage, bool select, Domain<dim> &domain, Ledger<dim> &ledger) const;

    /// Spread elements that are where their cells were evenly over the ranks: the partition is that of the cells, most
    /// of which have gone. Bits do not change.
    void
    spread(const Stage &stage, Domain<dim> &domain, Ledger<dim> &ledger) const;

    void
    paint(const Stage &stage, Domain<dim> &domain, Ledger<dim> &ledger) const;

    /// Cells around solid that may be asked for beyond the scene's buffer.
    static constexpr int largest_buffer = 1024;

    const Problem<dim>    &problem_;
    const Scene<dim>      &scene_;
    const FieldLayout     &layout_;
    const Regridding<dim> &regridding_;
  };
} // namespace whipple
