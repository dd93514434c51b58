// SPDX-License-Identifier: LGPL-2.1-or-later
#pragma once

#include <whipple/run/run_state.h>

#include <cstdint>
#include <vector>

namespace whipple
{
  /// The books of a run as bytes (CBOR, RFC 8949: JSON in binary), every number with all its bits.
  std::vector<std::uint8_t>
  to_cbor(const RunBooks<2> &books);

  /// What to_cbor() wrote. Of the summary, what is worked out at the end (ledger, errors, effects) is left empty.
  /// @throws StateError if the bytes are something else.
  RunBooks<2>
  books_from_cbor(const std::vector<std::uint8_t> &bytes);
} // namespace whipple
