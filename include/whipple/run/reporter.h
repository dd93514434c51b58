// SPDX-License-Identifier: LGPL-2.1-or-later
#pragma once

#include <whipple/ledger/ledger.h>
#include <whipple/output/field_output.h>
#include <whipple/output/run_log.h>
#include <whipple/output/statistics.h>
#include <whipple/output/summary.h>
#include <whipple/run/cycle.h>
#include <whipple/run/domain.h>

#include <string>

namespace whipple
{
  /// Where a stage stands after a step, for those who watch.
  struct StepNews
  {
    const Stage          *stage        = nullptr;
    int                   stage_number = 0;
    long                  step         = 0;
    double                dt           = 0; ///< us
    const AgreedTimeStep *limit        = nullptr;
    long                  cells        = 0; ///< active cells of all ranks
    double                fraction     = 0; ///< of the stage, estimated
  };

  /// Everything a run writes while it runs: log and terminal, statistics.csv, field files, the state after a failure.
  template <int dim>
  class Reporter
  {
  public:
    Reporter(const Scene<dim> &scene, const FieldLayout &layout, const std::string &directory, bool live,
             MPI_Comm communicator);

    RunLog &
    log()
    {
      return log_;
    }

    /// Begin a stage: one line, and the fields it starts from.
    void
    stage_begins(const Stage &stage, int number, const Domain<dim> &domain);

    /// Progress line, statistics row and field file where they are due.
    void
    step_done(const StepNews &news, const Domain<dim> &domain, const Ledger<dim> &ledger,
              const ConservedTotals<dim> &present);

    /// End a stage: its fields and its page of the ledger, per body where bodies can be told apart.
    void
    stage_ends(const Stage &stage, const Domain<dim> &domain, const Ledger<dim> &ledger);

    /// One line: "bumper hole_diameter_cm 0.68 +- 0.02 (monotone)".
    void
    result(const std::string &place, const std::string &quantity, const summary::Result &value,
           const summary::ErrorBar &bar);

    /// Write the last good state beside the output.
    void
    failed(const Stage &stage, const Domain<dim> &domain, const Ledger<dim> &ledger, const std::string &reason);

    void
    flush()
    {
      statistics_.flush();
    }

    /// The steps so far stand.
    void
    steps_stand()
    {
      statistics_.keep();
    }

    /// The steps since the last steps_stand() were undone: the time is `time` again.
    void
    steps_undone(double time);

  private:
    void
    write_fields(const Stage &stage, const Domain<dim> &domain);

    /// A warning for each event of the ledger that has grown since the last call.
    void
    warn_of_events(const Stage &stage, const Ledger<dim> &ledger);

    const Scene<dim>            &scene_;
    const FieldLayout           &layout_;
    std::string                  directory_;
    RunLog                       log_;
    Statistics                   statistics_;
    FieldOutput<dim>             fields_;
    std::map<std::string, Event> events_warned_;       ///< of the ledger, at the last warning
    double                       next_fields_     = 0; ///< us
    double                       next_statistics_ = 0; ///< us
  };
} // namespace whipple
