// SPDX-License-Identifier: LGPL-2.1-or-later
#include <whipple/error.h>
#include <whipple/study/child_run.h>

#include <fcntl.h>
#include <signal.h>
#include <sys/prctl.h>
#include <sys/wait.h>
#include <unistd.h>

#include <cerrno>
#include <cstring>
#include <filesystem>

namespace whipple
{
  namespace
  {
    /// The child's side of the fork: only calls that are safe there.
    [[noreturn]] void
    become(const std::string &program, char *const *words, int log, pid_t parent)
    {
      constexpr int cannot_start = 127;
      prctl(PR_SET_PDEATHSIG, SIGTERM);
      const bool orphaned = getppid() != parent;
      if (!orphaned && dup2(log, STDOUT_FILENO) >= 0 && dup2(log, STDERR_FILENO) >= 0)
        execv(program.c_str(), words);
      _exit(cannot_start);
    }
  } // namespace

  ChildRun::ChildRun(const std::vector<std::string> &arguments, const std::string &log)
  {
    const std::string        program = std::filesystem::read_symlink("/proc/self/exe");
    std::vector<std::string> words{program};
    words.insert(words.end(), arguments.begin(), arguments.end());
    std::vector<char *> argv;
    for (std::string &word : words)
      argv.push_back(word.data());
    argv.push_back(nullptr);

    constexpr mode_t readable = 0644;
    const int        file     = open(log.c_str(), O_WRONLY | O_CREAT | O_TRUNC | O_CLOEXEC, readable);
    if (file < 0)
      throw Error(log + ": cannot be written: " + std::strerror(errno));
    const pid_t parent = getpid();
    process_           = fork();
    if (process_ == 0)
      become(program, argv.data(), file, parent);
    close(file);
    if (process_ < 0)
      throw Error(std::string("no process can be started: ") + std::strerror(errno));
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
