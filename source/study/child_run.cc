// SPDX-License-Identifier: LGPL-2.1-or-later
#include <whipple/error.h>
#include <whipple/study/child_process.h>
#include <whipple/study/child_run.h>

#include <fcntl.h>
#include <signal.h>
#include <sys/wait.h>
#include <unistd.h>

#include <cerrno>
#include <cstring>

namespace whipple
{
  ChildRun::ChildRun(const std::vector<std::string> &arguments, const std::string &log)
  {
    constexpr mode_t readable = 0644;
    const int        file     = open(log.c_str(), O_WRONLY | O_CREAT | O_TRUNC | O_CLOEXEC, readable);
    if (file < 0)
      throw Error(log + ": cannot be written: " + std::strerror(errno));
    std::vector<std::string> words{child_process::this_program()};
    words.insert(words.end(), arguments.begin(), arguments.end());
    const auto into_log = [file] { return dup2(file, STDOUT_FILENO) >= 0 && dup2(file, STDERR_FILENO) >= 0; };
    try
      {
        process_ = child_process::start(std::move(words), into_log);
      }
    catch (...)
      {
        close(file);
        throw;
      }
    close(file);
  }

  ChildRun::~ChildRun()
  {
    if (status_)
      return;
    kill(process_, SIGTERM);
    waitpid(process_, nullptr, 0);
  }

  std::optional<std::string>
  ChildRun::ended()
  {
    if (!status_)
      {
        int         status   = 0;
        const pid_t finished = waitpid(process_, &status, WNOHANG);
        if (finished == 0 || (finished < 0 && errno == EINTR))
          return std::nullopt;
        status_ = status;
      }
    if (WIFSIGNALED(*status_))
      return "signal " + std::to_string(WTERMSIG(*status_)) + " (" + strsignal(WTERMSIG(*status_)) + ')';
    return "exit status " + std::to_string(WEXITSTATUS(*status_));
  }
} // namespace whipple
