// SPDX-License-Identifier: LGPL-2.1-or-later
#pragma once

namespace whipple
{
  /// Share of a cell's volume below which what a cut leaves of it is round-off: a body with less of a cell does not
  /// enter it, a cell that lacks less is full. An axis has up to 2^19 cells, so positions have, in cells, errors of up
  /// to 2^19 2^-53 = 6e-11.
  inline constexpr double round_off_share = 1e-10;
} // namespace whipple
