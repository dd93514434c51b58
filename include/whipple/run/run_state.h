// SPDX-License-Identifier: LGPL-2.1-or-later
#pragma once

#include <whipple/ledger/ledger.h>
#include <whipple/ledger/totals.h>
#include <whipple/output/summary.h>
#include <whipple/run/contact.h>
#include <whipple/run/domain.h>
#include <whipple/run/report_progress.h>
#include <whipple/run/time_step_history.h>

#include <limits>
#include <vector>

namespace whipple
{
  /// How far a stage has come: all that its next step depends on beside the mesh and its fields. Steps, time limits and
  /// the like are in the stage's summary.
  struct StageProgress
  {
    bool   begun          = false; ///< the hand-over into the stage is done
    double last_time_step = 0;     ///< us, not cut short by the end of the stage; 0 before the first step

    double ceiling      = std::numeric_limits<double>::infinity();  ///< us, largest step while a failure is retried
    double failed_until = -std::numeric_limits<double>::infinity(); ///< us, end of the step that failed
    int    retries      = 0;                                        ///< of the same failure

    long   since_regrid       = 0;  ///< steps since the mesh or its bonds were last looked at
    double spare_after_regrid = -1; ///< Fit::spare when first asked after a regrid; < 0: not yet

    double next_arrivals = 0; ///< us; when it is looked for debris that has arrived

    std::vector<double>  memory_of_end; ///< what the stage's end remembers (StageEnd::time_left)
    std::vector<CellKey> locked; ///< elements of all ranks that keep their shape: a step has folded them, or slivers
    std::size_t          locked_noted = 0; ///< of them, from the first on, those in the ledger
    TimeStepHistory      history;
    ContactSchedule      contacts;
  };

  /// All that a run is at a moment beside the mesh and its fields; a value.
  template <int dim>
  struct RunBooks
  {
    std::size_t      stage = 0; ///< number of the stage it is in, or will begin next
    StageProgress    progress;
    Ledger<dim>      ledger;
    summary::Summary summary; ///< stages so far, results, counts, what has been used
    ReportProgress   report;

    std::map<std::string, std::vector<double>>
        watches; ///< what each watch remembers (diagnostics/measure.h), by its name

    SharedDebris<dim> waiting; ///< debris on its way that is not in the domain
  };

  /// All that a run is at a moment. What can be worked out from it is no part of it.
  template <int dim>
  struct RunState
  {
    Domain<dim>   domain;
    RunBooks<dim> books;

    /// What the summary says of the present stage. @pre books.progress.begun
    summary::Stage &
    record()
    {
      return books.summary.stages.back();
    }

    /// What there is, in the domain and on its way. Collective.
    ConservedTotals<dim>
    present() const
    {
      auto sum = totals(domain.view->mesh, domain.state, domain.communicator());
      if (books.waiting)
        sum += books.waiting->totals;
      return sum;
    }
  };

  /// The same split by body. @pre layout.bodies_separable
  template <int dim>
  std::vector<ConservedTotals<dim>>
  present_bodies(const FieldLayout &layout, const RunState<dim> &run)
  {
    const State<dim> &state = run.domain.state;
    auto              bodies =
        body_totals(run.domain.view->mesh, state, layout.body_tag, layout.body_material, run.domain.communicator());
    if (run.books.waiting)
      {
        const auto waiting = body_totals(CellPacketLayout<dim>::of(state), run.books.waiting->parts, layout.body_tag,
                                         layout.body_material);
        for (std::size_t b = 0; b < bodies.size(); ++b)
          bodies[b] += waiting[b];
      }
    return bodies;
  }
} // namespace whipple
