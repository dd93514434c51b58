// SPDX-License-Identifier: LGPL-2.1-or-later
#include <whipple/command/mpirun.h>
#include <whipple/error.h>
#include <whipple/study/child_process.h>

#include <signal.h>
#include <sys/wait.h>
#include <unistd.h>

#include <array>
#include <cstdlib>
#include <string_view>
#include <utility>
#include <vector>

namespace whipple::mpirun
{
  namespace
  {
    constexpr const char *terminal_variable = "WHIPPLE_TERMINAL";

    constexpr std::array<std::pair<const char *, const char *>, 5> open_mpi_settings{{
        {"OMPI_MCA_rmaps_base_oversubscribe", "1"},
        {"OMPI_MCA_hwloc_base_binding_policy", "none"},
        {"OMPI_MCA_orte_execute_quiet", "1"},
        {"OMPI_MCA_btl_base_warn_component_unused", "0"},
        {"OMPI_MCA_btl_vader_single_copy_mechanism", "none"}, // containers forbid it, loudly
    }};

    /// Wait for mpirun and pass signals on to the ranks. It would end them within a second of a SIGTERM or SIGINT;
    /// SIGUSR1 and SIGUSR2 it only passes on, and to a rank SIGUSR2 means: stop.
    /// @returns as waitpid tells it
    int
    wait_for(pid_t child, const sigset_t &awaited)
    {
      bool asked = false;
      for (int status = 0, signal = 0;;)
        {
          if (sigwait(&awaited, &signal) != 0)
            continue;
          if (signal == SIGUSR1)
            kill(child, SIGUSR1);
          else if (signal != SIGCHLD)
            kill(child, std::exchange(asked, true) ? SIGTERM : SIGUSR2);
          else if (waitpid(child, &status, WNOHANG) == child)
            return status;
        }
    }
  } // namespace

  bool
  is_rank()
  {
    return std::getenv("OMPI_COMM_WORLD_SIZE") || std::getenv("PMI_SIZE") || std::getenv("PMI_RANK");
  }

  int
  run(int ranks, std::span<const std::string> arguments)
  {
    constexpr int keep = 0;
    for (const auto &[name, value] : open_mpi_settings)
      setenv(name, value, keep);
    if (geteuid() == 0)
      for (const char *name : {"OMPI_ALLOW_RUN_AS_ROOT", "OMPI_ALLOW_RUN_AS_ROOT_CONFIRM"})
        setenv(name, "1", keep);
    setenv(terminal_variable, isatty(STDOUT_FILENO) == 1 ? "1" : "0", 1);

    std::vector<std::string> words{"mpirun", "-n", std::to_string(ranks), child_process::this_program()};
    words.insert(words.end(), arguments.begin(), arguments.end());

    sigset_t awaited, before;
    sigemptyset(&awaited);
    for (const int signal : {SIGTERM, SIGINT, SIGUSR1, SIGCHLD})
      sigaddset(&awaited, signal);
    sigprocmask(SIG_BLOCK, &awaited, &before);
    const pid_t child  = child_process::start(std::move(words), [&before] {
      setpgid(0, 0); // what the terminal sends goes to the parent alone
      return sigprocmask(SIG_SETMASK, &before, nullptr) == 0;
    });
    const int   status = wait_for(child, awaited);
    sigprocmask(SIG_SETMASK, &before, nullptr);
    if (WIFEXITED(status) && WEXITSTATUS(status) == child_process::cannot_start)
      throw Error("mpirun cannot be started: is Open MPI installed?");
    return WIFEXITED(status) ? WEXITSTATUS(status) : 128 + WTERMSIG(status);
  }

  bool
  prints_to_terminal()
  {
    if (const char *word = std::getenv(terminal_variable))
      return std::string_view(word) == "1";
    return isatty(STDOUT_FILENO) == 1;
  }
} // namespace whipple::mpirun
