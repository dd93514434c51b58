// SPDX-License-Identifier: LGPL-2.1-or-later
#pragma once

#include <whipple/error.h>

#include <mpi.h>
#include <signal.h>

#include <array>
#include <optional>
#include <string>

namespace whipple
{
  /// A run that was asked to stop, or whose time is up: its state is in a checkpoint. Exit status 3.
  class Interrupted : public StateError
  {
  public:
    using StateError::StateError;
  };

  /// Notices that a run shall write a checkpoint or stop: signals (SIGTERM, SIGINT and SIGUSR2 stop, SIGUSR1 only asks
  /// for a checkpoint; the second that stops ends the program at once) and the wall clock. Signals of one rank count
  /// for all. While an object lives, it handles these signals.
  class Interruption
  {
  public:
    /// @param interval   wall time between checkpoints, s; none: no checkpoint for the clock's sake
    /// @param time_limit wall time of the run, s; none: no limit
    /// @param start      MPI_Wtime from which the limit counts
    Interruption(std::optional<double> interval, std::optional<double> time_limit, double start, MPI_Comm communicator);
    ~Interruption();

    Interruption(const Interruption &) = delete;
    Interruption &
    operator=(const Interruption &) = delete;

    struct Wish
    {
      bool        checkpoint = false;
      bool        stop       = false;
      std::string reason; ///< why stop
    };

    /// What is asked for since the last call. Collective; costs one small reduction.
    /// @param reserve wall time that stopping will take, s
    Wish
    poll(double reserve);

    /// A checkpoint has been written.
    void
    written();

  private:
    std::array<struct sigaction, 4> before_; ///< what was done about the signals

    std::optional<double> interval_;
    std::optional<double> time_limit_;
    MPI_Comm              communicator_;
    double                start_;       ///< MPI_Wtime
    double                written_;     ///< MPI_Wtime of the last checkpoint
    double                polled_;      ///< MPI_Wtime of the last poll
    double                longest_ = 0; ///< wall time between two polls, s
  };
} // namespace whipple
