// SPDX-License-Identifier: LGPL-2.1-or-later
#pragma once

#include <whipple/diagnostics/measure.h>
#include <whipple/output/directory_lock.h>
#include <whipple/problem/problem.h>
#include <whipple/run/checkpointing.h>
#include <whipple/run/handover.h>
#include <whipple/run/last_good.h>
#include <whipple/run/reporter.h>

#include <map>
#include <memory>
#include <string>
#include <utility>

namespace whipple
{
  /// Where and how a simulation runs.
  struct RunPlace
  {
    std::string directory;          ///< of the output, prepared
    bool        live       = false; ///< refresh the progress line on the terminal in place
    double      wall_start = 0;     ///< MPI_Wtime from which a wall time limit counts

    std::shared_ptr<const DirectoryLock> lock = {}; ///< keeps others out of the directory for as long as the run lives
  };

  /// A run: the chain of a scene's stages from first contact to the wall, with its output directory.
  template <int dim>
  class Simulation
  {
  public:
    /// Collective, as all that is not const.
    Simulation(const Problem<dim> &problem, const RunPlace &place, MPI_Comm communicator);

    /// Go on where a checkpoint of this scene stopped (run/resume.h finds it).
    /// @throws checkpoint::Unusable if the fields cannot be read
    Simulation(const Problem<dim> &problem, const RunPlace &place, const std::string &checkpoint,
               const RunBooks<dim> &books, MPI_Comm communicator);

    /// Run all stages that are left. summary.json is written in any case.
    /// @throws StateError where physics or numerics stopped the run; the last good state is on disk.
    /// @throws Interrupted where the run was asked to stop; its checkpoint is on disk.
    void
    run();

    /// Add error bars to the results of a finished run: lines at the end of the log, and summary.json anew.
    void
    report_error_bars(const std::map<std::string, std::map<std::string, summary::ErrorBar>> &error_bars);

    /// Where the run stands.
    const Domain<dim> &
    domain() const
    {
      return state_.domain;
    }
    const Ledger<dim> &
    ledger() const
    {
      return state_.books.ledger;
    }
    const summary::Summary &
    summary() const
    {
      return state_.books.summary;
    }
    RunLog &
    log()
    {
      return reporter_.log();
    }

  private:
    Simulation(const Problem<dim> &problem, const RunPlace &place, const RunBooks<dim> *books, MPI_Comm communicator);

    void
    run_stage();
    /// Hand over to the present stage. @throws StateError, after the state of before has been restored
    void
    enter();
    /// Whether a plate of the present stage could be measured at its end: thinner than a cell, it cannot.
    bool
    plates_are_seen() const;
    /// Go on with a copy of the stage's last state until its plates have settled, and measure them there.
    void
    follow_plates(const Stage &stage, const FieldLayout &layout);
    /// The present stage is over.
    void
    finish_stage();
    /// A moment at which measures look at the run.
    using Look = void (Measure<dim>::*)(const MeasureView<dim> &, MeasureReport &) const;
    /// All measures there are, in their order.
    void
    measure(Look look);
    void
    measure_errors();
    void
    write_summary();
    void
    stopped(const Stage &stage, const StateError &error);

    std::shared_ptr<const DirectoryLock> lock_; // the last to go

    Problem<dim>       problem_;
    const Scene<dim>  &scene_;
    const FieldLayout &layout_;
    std::string        directory_;
    Regridding<dim>    regridding_;
    Handover<dim>      handover_;
    RunState<dim>      state_;
    LastGood<dim>      last_good_;
    Reporter<dim>      reporter_;
    RunClock           clock_;
    Checkpointing<dim> checkpointing_;
  };
} // namespace whipple
