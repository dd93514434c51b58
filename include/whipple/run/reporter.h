// SPDX-License-Identifier: LGPL-2.1-or-later
#pragma once

#include <whipple/diagnostics/measure.h>
#include <whipple/output/field_output.h>
#include <whipple/output/step_table.h>
#include <whipple/output/summary.h>
#include <whipple/output/time_left.h>
#include <whipple/problem/problem.h>
#include <whipple/run/run_state.h>
#include <whipple/run/stage_news.h>

#include <string>

namespace whipple
{
  /// Everything a run writes while it runs: log and terminal, statistics.csv, field files, the state after a failure.
  /// How far it has come with that is part of the run state.
  template <int dim>
  class Reporter : public StageNews<dim>
  {
  public:
    /// @param resumed what an earlier part of the run has written: files are cut back to that, the log goes on; null: a
    ///                new run
    Reporter(const Problem<dim> &problem, const std::string &directory, bool live, MPI_Comm communicator,
             const RunBooks<dim> *resumed);

    RunLog &
    log() override
    {
      return log_;
    }

    /// Begin a stage: one line, and the fields it starts from.
    void
    stage_begins(const Stage &stage, RunState<dim> &run) override;

    /// The state of the present stage lies on another mesh: for the watches.
    void
    mesh_is_new(RunState<dim> &run) override;

    /// Progress line and statistics row, where it is due. The domain of the run may hold a part of what is present.
    void
    step_done(const StepNews &news, const ConservedTotals<dim> &present, RunState<dim> &run) override;

    /// Tables of the watches and field file, where they are due, after some steps with the whole domain in place.
    /// @param dt time since the last look, us
    void
    look(const Stage &stage, double dt, RunState<dim> &run) override;

    /// End a stage: its fields and its page of the ledger, per body where bodies can be told apart.
    void
    stage_ends(const Stage &stage, RunState<dim> &run) override;

    /// One line: "bumper hole_diameter_cm 0.68 +- 0.02 (monotone)".
    void
    result(const std::string &place, const std::string &quantity, const summary::Result &value,
           const summary::ErrorBar &bar);

    /// What a run has found and cost, and what to do with it: a few lines at its end.
    void
    tell(const summary::Summary &summary);

    /// Write the last good state beside the output.
    void
    failed(const Stage &stage, RunState<dim> &run, const std::string &reason);

    /// Bring to disk what stands.
    void
    flush();

    /// The steps so far stand.
    void
    steps_stand(RunBooks<dim> &books) override;

    /// The steps since the last steps_stand() were undone: the books are those of then.
    void
    steps_undone(const RunBooks<dim> &books) override;

  private:
    /// A row of statistics.csv.
    void
    write_statistics(const StepNews &news, const ConservedTotals<dim> &present, const RunState<dim> &run);

    void
    write_fields(const Stage &stage, RunState<dim> &run);

    /// A warning for each event of the ledger that has grown since the last call.
    void
    warn_of_events(const Stage &stage, RunBooks<dim> &books);

    /// A watch of a measure and its tables.
    struct Watching
    {
      std::string                             name;
      std::unique_ptr<const Watch<dim>>       watch;
      std::vector<WatchTable>                 tables;
      std::vector<std::unique_ptr<StepTable>> files;
    };

    void
    begin_watches(MPI_Comm communicator, const RunBooks<dim> *resumed);

    /// Let every watch look: call(watch, view, memory, write)
    template <typename Call>
    void
    let_watch(RunState<dim> &run, const Call &call);

    const Problem<dim> &problem_;
    const Scene<dim>   &scene_;
    const FieldLayout  &layout_;
    std::string         directory_;
    RunLog              log_;
    StepTable           statistics_;
    FieldOutput<dim>    fields_;
    TimeLeft            time_left_;

    std::vector<Watching> watching_;
  };
} // namespace whipple
