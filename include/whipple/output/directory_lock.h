// SPDX-License-Identifier: LGPL-2.1-or-later
#pragma once

#include <string>

namespace whipple
{
  /// Keeps a second run or study out of a directory for as long as it lives: an advisory lock (flock) on the file
  /// `.lock` there, which says who holds it. The system gives it back when the process ends, however that happens. The
  /// file stays. On file systems without such locks it holds nothing.
  class DirectoryLock
  {
  public:
    /// Holds nothing.
    DirectoryLock() = default;

    /// @param directory exists and can be written to
    /// @throws InputError if another process holds it: which, on which machine, since when.
    explicit DirectoryLock(const std::string &directory);

    DirectoryLock(DirectoryLock &&other) noexcept;
    DirectoryLock &
    operator=(DirectoryLock &&other) noexcept;
    ~DirectoryLock();

    /// Whether another process holds a directory, as far as one can see.
    static bool
    is_held(const std::string &directory);

    /// Name of the file, which does not make a directory one that is in use.
    static constexpr const char *file_name = ".lock";

  private:
    int descriptor_ = -1;
  };
} // namespace whipple
