// SPDX-License-Identifier: LGPL-2.1-or-later
#include <whipple/material/trial.h>

#include <fcntl.h>
#include <sys/resource.h>
#include <sys/wait.h>
#include <unistd.h>

#include <cerrno>
#include <csignal>

namespace whipple
{
  namespace
  {
    [[noreturn]] void
    run_and_end(const std::function<void()> &work, int seconds)
    {
      // a fault ends the copy without a word: MPI and sanitizers would report it
      for (const int signal : {SIGSEGV, SIGBUS, SIGFPE, SIGILL, SIGABRT, SIGXCPU})
        std::signal(signal, SIG_DFL);
      const int nowhere = open("/dev/null", O_WRONLY);
      dup2(nowhere, STDOUT_FILENO);
      dup2(nowhere, STDERR_FILENO);
      const rlimit time{static_cast<rlim_t>(seconds), static_cast<rlim_t>(seconds) + 1}, no_core{0, 0};
      setrlimit(RLIMIT_CPU, &time);
      setrlimit(RLIMIT_CORE, &no_core);
      try
        {
          work();
        }
      catch (...)
        {
        }
      _exit(0); // without the exit handlers of the process it is a copy of
    }
  } // namespace

  std::string
  failure_of_trial(const std::function<void()> &work, int seconds)
  {
    const pid_t child = fork();
    if (child < 0)
      return "";
    if (child == 0)
      run_and_end(work, seconds);
    int   status = 0;
    pid_t ended;
    do
      ended = waitpid(child, &status, 0);
    while (ended < 0 && errno == EINTR);
    if (ended < 0) // somebody else has taken its status
      return "";
    if (WIFSIGNALED(status))
      return "signal " + std::to_string(WTERMSIG(status));
    return WEXITSTATUS(status) == 0 ? "" : "status " + std::to_string(WEXITSTATUS(status));
  }
} // namespace whipple
