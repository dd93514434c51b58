// SPDX-License-Identifier: LGPL-2.1-or-later
#pragma once

#include <mpi.h>

#include <chrono>
#include <fstream>
#include <limits>
#include <ostream>
#include <string>
#include <string_view>

namespace whipple
{
  /// Where a run is, as shown on the progress line.
  struct Progress
  {
    std::string_view stage;
    long             step      = 0;
    double           time      = 0; ///< us
    double           time_step = 0; ///< us
    std::string_view limiter;       ///< what sets the time step
    long             cells = 0;     ///< active cells of all ranks
    /// Share of the stage that is done, 0 .. 1; not a number when it cannot be told.
    double fraction = std::numeric_limits<double>::quiet_NaN();
    /// Wall seconds that the stage and the whole run will still take; not a number when it cannot be told.
    double stage_left = std::numeric_limits<double>::quiet_NaN(), run_left = std::numeric_limits<double>::quiet_NaN();
  };

  /// What a run says: to DIR/log.txt and to the terminal, from rank 0; on the other ranks every call is free.
  /// On a terminal the progress line is refreshed in place, elsewhere it becomes a plain line now and then.
  class RunLog
  {
  public:
    /// What is there already of a log.
    enum class Earlier
    {
      replaced,
      kept ///< lines are added to it
    };

    /// Opens directory/log.txt. Terminal output goes to standard output.
    /// @param live refresh the progress line in place (a terminal); otherwise a plain line now and then
    /// Collective.
    /// @throws InputError on all ranks if the file cannot be written.
    RunLog(const std::string &directory, MPI_Comm communicator, bool live, Earlier earlier = Earlier::replaced);

    /// The same with the terminal given by the caller; `interval_seconds` is the least time between two progress
    /// lines on it.
    RunLog(const std::string &directory, MPI_Comm communicator, std::ostream &terminal, bool live,
           double interval_seconds, Earlier earlier = Earlier::replaced);

    /// Ends a pending progress line.
    ~RunLog();

    RunLog(const RunLog &) = delete;
    RunLog &
    operator=(const RunLog &) = delete;

    /// Versions of Whipple and of the libraries under it, ranks, vector width and build type.
    void
    banner();

    /// One line.
    void
    info(std::string_view line);

    /// One line marked as a warning, and counted (rank 0).
    void
    warning(std::string_view line);

    /// Call at every step; returns at once unless it is time for a line again. Lines go to log.txt every ten
    /// seconds whatever the terminal is.
    void
    progress(const Progress &progress);

    /// Number of warnings so far (0 on ranks other than 0).
    int
    warnings() const
    {
      return warnings_;
    }

    /// Count on from the warnings of an earlier part of the run (rank 0).
    void
    count_from(int warnings)
    {
      if (active_)
        warnings_ = warnings;
    }

    /// Seconds since the log was opened.
    double
    wall_seconds() const;

  private:
    using Clock = std::chrono::steady_clock;

    void
    line(std::string_view text);
    /// With something else on the terminal.
    void
    line(std::string_view text, std::string_view on_terminal);

    bool              active_; ///< this is rank 0
    MPI_Comm          communicator_;
    std::ostream     &terminal_;
    bool              live_;
    double            interval_;
    std::ofstream     file_;
    Clock::time_point start_;
    double            next_terminal_ = 0; ///< wall seconds before which no progress line is due
    double            next_file_     = 0;
    std::size_t       live_width_    = 0; ///< characters of the line being refreshed, 0 if none
    int               warnings_      = 0;
  };
} // namespace whipple
