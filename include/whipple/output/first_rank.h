// SPDX-License-Identifier: LGPL-2.1-or-later
#pragma once

#include <mpi.h>

#include <exception>
#include <string>

namespace whipple
{
  inline bool
  is_first_rank(MPI_Comm communicator)
  {
    int rank = 0;
    MPI_Comm_rank(communicator, &rank);
    return rank == 0;
  }

  /// The text that the first rank has, on all. Collective.
  inline std::string
  from_first_rank(std::string text, MPI_Comm communicator)
  {
    unsigned long size = text.size();
    MPI_Bcast(&size, 1, MPI_UNSIGNED_LONG, 0, communicator);
    text.resize(size);
    MPI_Bcast(text.data(), static_cast<int>(size), MPI_CHAR, 0, communicator);
    return text;
  }

  /// Do something on the first rank only, what touches the disk; all ranks wait for it. Collective; `work` must not
  /// communicate.
  /// @throws Failure on all ranks, with the message of what was thrown
  template <typename Failure, typename Work>
  void
  on_first_rank(MPI_Comm communicator, const Work &work)
  {
    std::string message;
    int         failed = 0;
    if (is_first_rank(communicator))
      try
        {
          work();
        }
      catch (const std::exception &error)
        {
          message = error.what();
          failed  = 1;
        }
    MPI_Bcast(&failed, 1, MPI_INT, 0, communicator);
    if (failed)
      throw Failure(from_first_rank(message, communicator));
  }
} // namespace whipple
