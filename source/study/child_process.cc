// SPDX-License-Identifier: LGPL-2.1-or-later
#include <whipple/error.h>
#include <whipple/study/child_process.h>

#include <signal.h>
#include <sys/prctl.h>
#include <unistd.h>

#include <cerrno>
#include <cstring>
#include <filesystem>

namespace whipple::child_process
{
  std::string
  this_program()
  {
    return std::filesystem::read_symlink("/proc/self/exe");
  }

  pid_t
  start(std::vector<std::string> words, const std::function<bool()> &prepare)
  {
    std::vector<char *> argv;
    for (std::string &word : words)
      argv.push_back(word.data());
    argv.push_back(nullptr);
    const pid_t parent = getpid(), child = fork();
    if (child == 0)
      {
        prctl(PR_SET_PDEATHSIG, SIGTERM);
        const bool orphaned = getppid() != parent; // before it was asked for
        if (!orphaned && prepare())
          execvp(argv[0], argv.data());
        _exit(cannot_start);
      }
    if (child < 0)
      throw Error(words[0] + ": no process can be started: " + std::strerror(errno));
    return child;
  }
} // namespace whipple::child_process
