// SPDX-License-Identifier: LGPL-2.1-or-later
#pragma once

#include <malloc.h>

#include <cstddef>

namespace whipple::bench
{
  /// Bytes that the program holds from the allocator at this moment.
  inline std::size_t
  bytes_in_use()
  {
    const auto use = mallinfo2();
    return use.uordblks + use.hblkhd;
  }
} // namespace whipple::bench
