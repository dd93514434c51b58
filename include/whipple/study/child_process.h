// SPDX-License-Identifier: LGPL-2.1-or-later
#pragma once

#include <sys/types.h>

#include <functional>
#include <string>
#include <vector>

namespace whipple::child_process
{
  /// Exit status of a child whose program could not be started.
  inline constexpr int cannot_start = 127;

  /// File name of this program.
  std::string
  this_program();

  /// Start a program as a child process. It gets SIGTERM when this one ends, however that comes about.
  /// @param words    the program and its arguments
  /// @param prepare  called in the child before the program starts: only calls that are safe after a fork. False: the
  ///                 child ends with `cannot_start`
  /// @throws Error if there can be no other process
  pid_t
  start(std::vector<std::string> words, const std::function<bool()> &prepare);
} // namespace whipple::child_process
