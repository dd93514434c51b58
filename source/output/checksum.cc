// SPDX-License-Identifier: LGPL-2.1-or-later
#include <whipple/error.h>
#include <whipple/mesh/gather.h>
#include <whipple/output/checksum.h>

#include <zlib.h>

#include <algorithm>
#include <cstdio>
#include <fstream>
#include <vector>

namespace whipple::checksum
{
  namespace
  {
    std::uint32_t
    go_on(std::uint32_t checksum, std::span<const std::byte> bytes)
    {
      constexpr std::size_t most = 1u << 30; // zlib takes an unsigned int
      while (!bytes.empty())
        {
          const auto part = bytes.first(std::min(bytes.size(), most));
          checksum        = static_cast<std::uint32_t>(
              crc32(checksum, reinterpret_cast<const Bytef *>(part.data()), static_cast<uInt>(part.size())));
          bytes = bytes.subspan(part.size());
        }
      return checksum;
    }
  } // namespace

  std::uint32_t
  of(std::span<const std::byte> bytes)
  {
    return go_on(0, bytes);
  }

  std::uint32_t
  of_all_ranks(std::span<const std::byte> bytes, MPI_Comm communicator)
  {
    struct Part
    {
      std::uint64_t size;
      std::uint32_t checksum;
    };
    const Part    own{bytes.size(), of(bytes)};
    std::uint32_t all = 0;
    for (const Part &part : gather_all<Part>(communicator, std::span<const Part>(&own, 1)).entry)
      all = static_cast<std::uint32_t>(crc32_combine(all, part.checksum, static_cast<z_off_t>(part.size)));
    return all;
  }

  std::uint32_t
  of_file(const std::string &path)
  {
    std::ifstream file(path, std::ios::binary);
    if (!file)
      throw Error(path + ": cannot be read");
    std::vector<char> block(1u << 20);
    std::uint32_t     checksum = 0;
    while (file.read(block.data(), static_cast<std::streamsize>(block.size())) || file.gcount() > 0)
      checksum =
          go_on(checksum, std::as_bytes(std::span<const char>(block.data(), static_cast<std::size_t>(file.gcount()))));
    return checksum;
  }

  std::string
  text(std::uint32_t checksum)
  {
    char digits[9];
    std::snprintf(digits, sizeof digits, "%08x", checksum);
    return digits;
  }
} // namespace whipple::checksum
