// SPDX-License-Identifier: LGPL-2.1-or-later
#include <whipple/error.h>
#include <whipple/output/directory_lock.h>

#include <fcntl.h>
#include <sys/file.h>
#include <unistd.h>

#include <array>
#include <cerrno>
#include <cstring>
#include <ctime>
#include <utility>

namespace whipple
{
  namespace
  {
    /// "process 4711 on box, since 2026-11-30 12:00:00"
    std::string
    this_process()
    {
      std::array<char, 256> host{}, when{};
      gethostname(host.data(), host.size() - 1);
      const std::time_t now = std::time(nullptr);
      std::tm           local{};
      localtime_r(&now, &local);
      std::strftime(when.data(), when.size(), "%Y-%m-%d %H:%M:%S", &local);
      return "process " + std::to_string(getpid()) + " on " + host.data() + ", since " + when.data();
    }

    std::string
    holder(int descriptor)
    {
      std::array<char, 512> text{};
      const ssize_t         length = pread(descriptor, text.data(), text.size() - 1, 0);
      return length > 0 ? std::string(text.data(), static_cast<std::size_t>(length)) : std::string("unknown");
    }
  } // namespace

  DirectoryLock::DirectoryLock(const std::string &directory)
  {
    const std::string path = directory + '/' + file_name;
    descriptor_            = open(path.c_str(), O_RDWR | O_CREAT | O_CLOEXEC, 0644);
    if (descriptor_ < 0)
      throw InputError("output directory '" + directory + "' cannot be written to: " + std::strerror(errno));
    if (flock(descriptor_, LOCK_EX | LOCK_NB) != 0)
      {
        if (errno != EWOULDBLOCK)
          return; // this file system has no locks
        const std::string other = holder(descriptor_);
        close(std::exchange(descriptor_, -1));
        throw InputError("output directory '" + directory + "' is in use by another run or study (" + other +
                         "); nothing overwritten, give another --output or wait");
      }
    const std::string text = this_process();
    if (ftruncate(descriptor_, 0) != 0 || pwrite(descriptor_, text.data(), text.size(), 0) < 0)
      throw InputError("output directory '" + directory + "' cannot be written to: " + std::strerror(errno));
  }

  bool
  DirectoryLock::is_held(const std::string &directory)
  {
    const int descriptor = open((directory + '/' + file_name).c_str(), O_RDONLY | O_CLOEXEC);
    if (descriptor < 0)
      return false;
    const bool held = flock(descriptor, LOCK_SH | LOCK_NB) != 0 && errno == EWOULDBLOCK;
    close(descriptor);
    return held;
  }

  DirectoryLock::DirectoryLock(DirectoryLock &&other) noexcept
    : descriptor_(std::exchange(other.descriptor_, -1))
  {
  }

  DirectoryLock &
  DirectoryLock::operator=(DirectoryLock &&other) noexcept
  {
    std::swap(descriptor_, other.descriptor_);
    return *this;
  }

  DirectoryLock::~DirectoryLock()
  {
    if (descriptor_ >= 0)
      close(descriptor_);
  }
} // namespace whipple
