// SPDX-License-Identifier: LGPL-2.1-or-later
#include <whipple/command/mpirun.h>
#include <whipple/error.h>

#include <unistd.h>

#include <array>
#include <cerrno>
#include <cstdlib>
#include <cstring>
#include <filesystem>
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
  } // namespace

  bool
  is_rank()
  {
    return std::getenv("OMPI_COMM_WORLD_SIZE") || std::getenv("PMI_SIZE") || std::getenv("PMI_RANK");
  }

  void
  become(int ranks, std::span<const std::string> arguments)
  {
    constexpr int keep = 0;
    for (const auto &[name, value] : open_mpi_settings)
      setenv(name, value, keep);
    if (geteuid() == 0)
      for (const char *name : {"OMPI_ALLOW_RUN_AS_ROOT", "OMPI_ALLOW_RUN_AS_ROOT_CONFIRM"})
        setenv(name, "1", keep);
    setenv(terminal_variable, isatty(STDOUT_FILENO) == 1 ? "1" : "0", 1);

    const std::string        program = std::filesystem::read_symlink("/proc/self/exe");
    std::vector<std::string> words{"mpirun", "-n", std::to_string(ranks), program};
    words.insert(words.end(), arguments.begin(), arguments.end());
    std::vector<char *> argv;
    for (std::string &word : words)
      argv.push_back(word.data());
    argv.push_back(nullptr);
    execvp(argv[0], argv.data());
    throw Error(std::string("mpirun cannot be started: ") + std::strerror(errno));
  }

  bool
  prints_to_terminal()
  {
    if (const char *word = std::getenv(terminal_variable))
      return std::string_view(word) == "1";
    return isatty(STDOUT_FILENO) == 1;
  }
} // namespace whipple::mpirun
