// SPDX-License-Identifier: LGPL-2.1-or-later
#include <whipple/error.h>
#include <whipple/output/disk_room.h>
#include <whipple/output/first_rank.h>

#include <cstdint>
#include <cstdio>
#include <filesystem>

namespace whipple
{
  namespace
  {
    /// What HDF5 writes beside the values: headers of datasets, attributes, tables of contents.
    constexpr double        share_of_values = 0.02;
    constexpr std::uint64_t beside_values   = 256 * 1024;

    std::string
    megabytes(double bytes)
    {
      char text[32];
      std::snprintf(text, sizeof text, "%.3g MB", 1e-6 * bytes);
      return text;
    }
  } // namespace

  void
  require_disk_room(const std::string &path, const std::size_t bytes, MPI_Comm communicator)
  {
    std::uint64_t all = bytes;
    MPI_Allreduce(MPI_IN_PLACE, &all, 1, MPI_UINT64_T, MPI_SUM, communicator);
    on_first_rank<Error>(communicator, [&] {
      const double    needed = (1. + share_of_values) * static_cast<double>(all) + beside_values;
      std::error_code failure;
      const auto      space = std::filesystem::space(std::filesystem::path(path).parent_path(), failure);
      if (failure)
        throw Error(path + ": cannot be written: " + failure.message());
      if (static_cast<double>(space.available) < needed)
        throw Error(path + ": No space left on device: about " + megabytes(needed) + " are needed, " +
                    megabytes(static_cast<double>(space.available)) + " are free");
    });
  }
} // namespace whipple
