// SPDX-License-Identifier: LGPL-2.1-or-later
#pragma once

#include <whipple/output/process_use.h>
#include <whipple/output/summary.h>
#include <whipple/run/phase_clock.h>

#include <mpi.h>

namespace whipple
{
  /// What a run has used, its parts before a restart included.
  class RunClock
  {
  public:
    /// Begins to count. Collective. @param earlier what was used before
    RunClock(const summary::Performance &earlier, MPI_Comm communicator)
      : earlier_(earlier)
      , communicator_(communicator)
      , wall_start_(MPI_Wtime())
      , cpu_start_(process_use(communicator).cpu_s) // the process may have worked before
    {
    }

    /// Enter wall time, computing time and memory up to now. Collective.
    void
    read(summary::Performance &performance) const
    {
      const ProcessUse use       = process_use(communicator_);
      performance.wall_s         = earlier_.wall_s + MPI_Wtime() - wall_start_;
      performance.cpu_s          = earlier_.cpu_s + use.cpu_s - cpu_start_;
      performance.peak_rss_bytes = use.peak_rss_bytes;
      MPI_Comm_size(communicator_, &performance.ranks);
      performance.phases = earlier_.phases;
      for (const auto &[phase, seconds] : phases_.seconds())
        performance.phases[phase] += seconds;
    }

    /// What the time is spent on.
    PhaseClock &
    phases()
    {
      return phases_;
    }

  private:
    summary::Performance earlier_;
    MPI_Comm             communicator_;
    double               wall_start_, cpu_start_;
    PhaseClock           phases_;
  };
} // namespace whipple
