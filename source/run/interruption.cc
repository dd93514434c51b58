// SPDX-License-Identifier: LGPL-2.1-or-later
#include <whipple/output/duration.h>
#include <whipple/run/interruption.h>

#include <algorithm>
#include <cstring>

namespace whipple
{
  namespace
  {
    // A signal handler can reach nothing but these.
    volatile sig_atomic_t stop_signal       = 0;
    volatile sig_atomic_t checkpoint_signal = 0;

    constexpr std::array signals{SIGTERM, SIGINT, SIGUSR2, SIGUSR1};

    void
    remember(int signal)
    {
      if (signal == SIGUSR1)
        checkpoint_signal = 1;
      else
        stop_signal = signal;
    }

    /// @returns what was done about it before
    struct sigaction
    handle(int signal)
    {
      struct sigaction action
      {
      }, before{};
      action.sa_handler = remember;
      sigemptyset(&action.sa_mask);
      // who asks twice to stop means it
      action.sa_flags = SA_RESTART | (signal == SIGUSR1 ? 0 : static_cast<int>(SA_RESETHAND));
      sigaction(signal, &action, &before);
      return before;
    }
  } // namespace

  Interruption::Interruption(std::optional<double> interval, std::optional<double> time_limit, double start,
                             MPI_Comm communicator)
    : interval_(interval)
    , time_limit_(time_limit)
    , communicator_(communicator)
    , start_(start)
    , written_(MPI_Wtime())
    , polled_(written_)
  {
    stop_signal       = 0;
    checkpoint_signal = 0;
    for (std::size_t i = 0; i < signals.size(); ++i)
      before_[i] = handle(signals[i]);
  }

  Interruption::~Interruption()
  {
    for (std::size_t i = 0; i < signals.size(); ++i)
      sigaction(signals[i], &before_[i], nullptr);
  }

  Interruption::Wish
  Interruption::poll(double reserve)
  {
    const double now = MPI_Wtime();
    longest_         = std::max(longest_, now - polled_);
    polled_          = now;

    enum
    {
      signal,
      asked,
      due,
      late,
      number
    };
    std::array<int, number> wishes{stop_signal, checkpoint_signal, 0, 0};
    int                     rank = 0;
    MPI_Comm_rank(communicator_, &rank);
    if (rank == 0) // one clock for all
      {
        wishes[due]  = interval_ && now - written_ >= *interval_;
        wishes[late] = time_limit_ && now - start_ + reserve + 2. * longest_ >= *time_limit_;
      }
    checkpoint_signal = 0;
    MPI_Allreduce(MPI_IN_PLACE, wishes.data(), number, MPI_INT, MPI_MAX, communicator_);

    Wish wish;
    wish.stop       = wishes[signal] || wishes[late];
    wish.checkpoint = wish.stop || wishes[asked] || wishes[due];
    if (wishes[signal])
      wish.reason = wishes[signal] == SIGUSR2
                        ? "asked to stop" // by the launcher of the ranks
                        : "signal " + std::to_string(wishes[signal]) + " (" + strsignal(wishes[signal]) + ')';
    else if (wishes[late])
      wish.reason = "the wall time limit of " + duration(*time_limit_) + " is reached";
    return wish;
  }

  void
  Interruption::written()
  {
    written_ = polled_ = MPI_Wtime();
  }
} // namespace whipple
