// SPDX-License-Identifier: LGPL-2.1-or-later
#pragma once

#include <whipple/error.h>

#include <mpi.h>

#include <algorithm>
#include <array>
#include <string>

namespace whipple
{
  /// Run a piece of work that may find a bad state on one rank only; afterwards either all ranks go on or all
  /// throw the same StateError (that of the lowest rank that failed). @p work must not communicate.
  template <typename Work>
  void
  agree(MPI_Comm communicator, const Work &work)
  {
    std::string message;
    int         rank = 0, size = 1;
    MPI_Comm_rank(communicator, &rank);
    MPI_Comm_size(communicator, &size);
    int failed = size;
    try
      {
        work();
      }
    catch (const StateError &error)
      {
        message = error.what();
        failed  = rank;
      }
    MPI_Allreduce(MPI_IN_PLACE, &failed, 1, MPI_INT, MPI_MIN, communicator);
    if (failed == size)
      return;
    int length = static_cast<int>(message.size());
    MPI_Bcast(&length, 1, MPI_INT, failed, communicator);
    message.resize(length);
    MPI_Bcast(message.data(), length, MPI_CHAR, failed, communicator);
    throw StateError(message);
  }

  /// The same for work that communicates now and then: `work(meet)` calls the collective `meet()` before it does. If a
  /// rank has failed before, all ranks leave the work there; nobody waits for it.
  template <typename Work>
  void
  agree_in_parts(MPI_Comm communicator, const Work &work)
  {
    bool       left = false; // by all ranks: they have met, and one had failed
    const auto meet = [&] {
      left = true;
      agree(communicator, [] {});
      left = false;
    };
    try
      {
        work(meet);
      }
    catch (const StateError &)
      {
        if (left)
          throw;
        agree(communicator, [] { throw; });
      }
    agree(communicator, [] {});
  }

  /// Sum over the ranks, in rank order where that matters little (counts, wall times).
  inline double
  sum_over_ranks(double value, MPI_Comm communicator)
  {
    MPI_Allreduce(MPI_IN_PLACE, &value, 1, MPI_DOUBLE, MPI_SUM, communicator);
    return value;
  }

  inline double
  max_over_ranks(double value, MPI_Comm communicator)
  {
    MPI_Allreduce(MPI_IN_PLACE, &value, 1, MPI_DOUBLE, MPI_MAX, communicator);
    return value;
  }
} // namespace whipple
