// SPDX-License-Identifier: LGPL-2.1-or-later
#include <whipple/output/process_use.h>

#include <sys/resource.h>

#include <array>

namespace whipple
{
  ProcessUse
  process_use(MPI_Comm communicator)
  {
    rusage usage{};
    getrusage(RUSAGE_SELF, &usage);
    const auto seconds = [](const timeval &t) {
      return static_cast<double>(t.tv_sec) + 1e-6 * static_cast<double>(t.tv_usec);
    };
    // Linux reports the peak in units of 1024 bytes
    std::array<double, 2> sum{{seconds(usage.ru_utime) + seconds(usage.ru_stime), 1024. * usage.ru_maxrss}};
    MPI_Allreduce(MPI_IN_PLACE, sum.data(), 2, MPI_DOUBLE, MPI_SUM, communicator);
    return {sum[0], sum[1]};
  }
} // namespace whipple
