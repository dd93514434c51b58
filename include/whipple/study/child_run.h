// SPDX-License-Identifier: LGPL-2.1-or-later
#pragma once

#include <sys/types.h>

#include <optional>
#include <string>
#include <vector>

namespace whipple
{
  /// This program, started once more as a process of its own: what crashes there is told here and no more. It ends
  /// with its parent. MPI must not be up in the parent.
  class ChildRun
  {
  public:
    /// @param arguments what follows the program's name
    /// @param log       file that receives standard output and standard error
    /// @throws Error if no process can be started.
    ChildRun(const std::vector<std::string> &arguments, const std::string &log);

    ChildRun(const ChildRun &) = delete;
    ChildRun &
    operator=(const ChildRun &) = delete;

    /// Ends the child if it still runs.
    ~ChildRun();

    /// Empty while it runs; then how it ended, "exit status 3" or "signal 9 (Killed)".
    std::optional<std::string>
    ended();

    /// Its exit status was 0. @pre ended()
    bool
    succeeded() const
    {
      return status_ == 0;
    }

  private:
    pid_t              process_ = -1;
    std::optional<int> status_;
  };
} // namespace whipple
