// SPDX-License-Identifier: LGPL-2.1-or-later
// libFuzzer's entry into one target; what escapes it is reported with the bytes that did it.
#include "targets.h"

#include <cstddef>
#include <cstdint>

extern "C" int
LLVMFuzzerTestOneInput(const std::uint8_t *data, std::size_t size)
{
  whipple::fuzz::WHIPPLE_FUZZ_TARGET({reinterpret_cast<const char *>(data), size});
  return 0;
}
