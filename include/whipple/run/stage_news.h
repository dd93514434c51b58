// SPDX-License-Identifier: LGPL-2.1-or-later
#pragma once

#include <whipple/ledger/ledger.h>
#include <whipple/output/run_log.h>
#include <whipple/run/cycle.h>
#include <whipple/run/run_state.h>
#include <whipple/scene/scene.h>

namespace whipple
{
  /// Where a stage stands after a step, for those who watch.
  struct StepNews
  {
    const Stage          *stage    = nullptr;
    long                  step     = 0;
    double                dt       = 0; ///< us
    const AgreedTimeStep *limit    = nullptr;
    long                  cells    = 0; ///< active cells of all ranks
    double                fraction = 0; ///< of the stage, estimated
  };

  /// What a stage tells while it runs. By itself nobody listens: only warnings reach the log.
  template <int dim>
  class StageNews
  {
  public:
    virtual ~StageNews() = default;

    virtual RunLog &
    log() = 0;

    /// A stage begins with the state of the run.
    virtual void
    stage_begins(const Stage &, RunState<dim> &)
    {
    }

    /// The state of the present stage lies on another mesh: for the watches.
    virtual void
    mesh_is_new(RunState<dim> &)
    {
    }

    /// After a step. The domain of the run may hold a part of what is present.
    virtual void
    step_done(const StepNews &, const ConservedTotals<dim> &, RunState<dim> &)
    {
    }

    /// After some steps, with the whole domain in place; dt: time since the last look, us.
    virtual void
    look(const Stage &, double /*dt*/, RunState<dim> &)
    {
    }

    virtual void
    stage_ends(const Stage &, RunState<dim> &)
    {
    }

    /// The steps so far stand.
    virtual void
    steps_stand(RunBooks<dim> &)
    {
    }

    /// The steps since the last steps_stand() were undone: the books are those of then.
    virtual void
    steps_undone(const RunBooks<dim> &)
    {
    }
  };
} // namespace whipple
