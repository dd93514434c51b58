// SPDX-License-Identifier: LGPL-2.1-or-later
#pragma once

#include <functional>
#include <string>

namespace whipple
{
  /// Do `work` in a copy of this process, whose effects and output are lost, to learn whether it can be done: for
  /// libraries that a damaged file makes crash or loop (HDF5 1.10 does). What it throws counts as done.
  /// @param seconds of computing time that it may take
  /// @returns what ended the copy, "signal 11"; empty if it came to its end, or if there can be no copy.
  std::string
  failure_of_trial(const std::function<void()> &work, int seconds);
} // namespace whipple
