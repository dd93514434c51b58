// SPDX-License-Identifier: LGPL-2.1-or-later
#pragma once

#include <mpi.h>

#include <cstdint>
#include <span>
#include <string>

/// CRC-32 (that of zlib, gzip and PNG): tells damaged data from sound.
namespace whipple::checksum
{
  std::uint32_t
  of(std::span<const std::byte> bytes);

  /// Of the concatenation of all ranks' bytes in the order of ranks, the same however they are spread. Collective.
  std::uint32_t
  of_all_ranks(std::span<const std::byte> bytes, MPI_Comm communicator);

  /// Of a file's contents. @throws Error if it cannot be read.
  std::uint32_t
  of_file(const std::string &path);

  /// Eight hexadecimal digits.
  std::string
  text(std::uint32_t checksum);
} // namespace whipple::checksum
