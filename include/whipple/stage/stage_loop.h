// SPDX-License-Identifier: LGPL-2.1-or-later
#pragma once

#include <whipple/hydro/fragment_release.h>
#include <whipple/output/summary.h>
#include <whipple/stage/contact.h>
#include <whipple/stage/cycle.h>
#include <whipple/stage/handover.h>
#include <whipple/stage/regridding.h>
#include <whipple/stage/reporter.h>
#include <whipple/stage/state_guard.h>
#include <whipple/stage/time_step_history.h>

#include <memory>

namespace whipple
{
  /// Steps one stage from its first to its last instant: time steps, regrids, retries, news.
  template <int dim>
  class StageLoop
  {
  public:
    /// @param record what the summary says of the stage, up to date also when the stage stops early
    StageLoop(const Scene<dim> &scene, const FieldLayout &layout, const Regridding<dim> &regridding,
              const Handover<dim> &handover, const Stage &stage, int number, Reporter<dim> &reporter,
              summary::Stage &record);

    /// @param counts retries and releases are added to it
    /// @throws StateError on all ranks, after the last good state has been restored to `domain`
    void
    run(Domain<dim> &domain, Ledger<dim> &ledger, summary::Counts &counts);

  private:
    /// What a failed step goes back to.
    struct Snapshot
    {
      State<dim>                  state;
      Ledger<dim>                 ledger;
      long                        step = 0;
      std::map<std::string, long> dt_limits;
    };

    void
    new_mesh(Domain<dim> &domain);
    void
    regrid(Domain<dim> &domain, Ledger<dim> &ledger);
    /// @returns the fragments that keep their shape in the step ahead
    std::vector<RigidFragment<dim>>
    release(Domain<dim> &domain, Ledger<dim> &ledger, summary::Counts &counts);
    /// Every so many steps: break the bonds of elements that are intact no longer. @returns whether any broke
    bool
    bonds_break(Domain<dim> &domain, Ledger<dim> &ledger, summary::Counts &counts);
    /// Take elements that are about to fold, or did in the step that was undone, out of the mesh.
    void
    free_folding(Domain<dim> &domain, Ledger<dim> &ledger, summary::Counts &counts);
    /// Lock slivers that would make the step much shorter than it is in this stage. @returns whether there were new
    /// ones
    bool
    lock_slivers(const Domain<dim> &domain);
    void
    lock(const std::vector<Index> &cells);
    /// @throws StateError if a step has folded an element; the elements are freed in the next try, and locked
    void
    refuse_folded(const Domain<dim> &domain);
    /// Join elements that have run into one another; lay all anew if that does not do. @returns whether the mesh is new
    bool
    meet(Domain<dim> &domain, Ledger<dim> &ledger, summary::Counts &counts);
    bool
    regrid_is_due(const Domain<dim> &domain);
    bool
    guard_touched(const Domain<dim> &domain) const;
    double
    choose_time_step(const Domain<dim> &domain, double left);
    double
    time_left(const Domain<dim> &domain);
    /// @throws StateError, after the record has been closed, if the time step has collapsed.
    void
    stop_if_collapsed(const Domain<dim> &domain);
    void
    close_record(const Domain<dim> &domain);
    void
    step(Domain<dim> &domain, Ledger<dim> &ledger, summary::Counts &counts, double left);
    void
    take_snapshot(const Domain<dim> &domain, Ledger<dim> &ledger);
    /// Enter into the ledger what has been locked since this was asked last.
    void
    note_locked(const Domain<dim> &domain, Ledger<dim> &ledger);
    void
    go_back(Domain<dim> &domain, Ledger<dim> &ledger, summary::Counts &counts, const StateError &error);

    const Scene<dim>      &scene_;
    const FieldLayout     &layout_;
    const Regridding<dim> &regridding_;
    const Handover<dim>   &handover_;
    const Stage           &stage_;
    int                    number_;
    Reporter<dim>         &reporter_;
    summary::Stage        &record_;

    std::unique_ptr<Cycle<dim>> cycle_;
    std::vector<Index>          guard_;
    Snapshot                    snapshot_;
    RigidWalls<dim>             walls_;
    ContactSchedule             contacts_;
    std::vector<Index>
        locked_; ///< owned cells that keep their shape, ascending: a step has folded them, or they are slivers
    std::vector<Index> new_locked_; ///< of them, those not yet in the ledger
    AgreedTimeStep     limit_{};
    StateGuard<dim>    state_guard_;
    double             wall_start_;
    double             end_time_     = 0;                                        ///< us; of stages that end at a time
    double             last_dt_      = 0;                                        ///< us; 0 before the first step
    double             tried_dt_     = 0;                                        ///< us; the step being made
    double             ceiling_      = std::numeric_limits<double>::infinity();  ///< us; of retries
    double             failed_until_ = -std::numeric_limits<double>::infinity(); ///< us; end of the step that failed
    TimeStepHistory    history_;
    long               cells_              = 0;  ///< active cells of all ranks
    long               since_regrid_       = 0;  ///< steps since the mesh or its bonds were last looked at
    double             spare_after_regrid_ = -1; ///< Fit::spare when first asked after a regrid; < 0: not yet
    int                retries_            = 0;  ///< of the same failure
  };
} // namespace whipple
