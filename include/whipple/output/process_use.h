// SPDX-License-Identifier: LGPL-2.1-or-later
#pragma once

#include <mpi.h>

namespace whipple
{
  /// What the processes of a run have used so far.
  struct ProcessUse
  {
    double cpu_s          = 0; ///< user and system time, sum over the ranks
    double peak_rss_bytes = 0; ///< peak resident memory, sum over the ranks
  };

  /// Ask the operating system. Collective.
  ProcessUse
  process_use(MPI_Comm communicator);
} // namespace whipple
