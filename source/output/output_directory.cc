// SPDX-License-Identifier: LGPL-2.1-or-later
#include <whipple/error.h>
#include <whipple/output/first_rank.h>
#include <whipple/output/output_directory.h>

#include <algorithm>
#include <filesystem>
#include <fstream>

namespace whipple
{
  namespace
  {
    namespace fs = std::filesystem;

    /// The first line of a run's log.txt starts with this (see RunLog::banner).
    constexpr const char *log_mark = "Whipple";

    bool
    is_output_of_a_run(const fs::path &directory)
    {
      std::ifstream log(directory / "log.txt");
      std::string   word;
      return static_cast<bool>(log >> word) && word == log_mark;
    }

    /// Nothing but the lock of a run that has not begun, or of one that left nothing.
    bool
    holds_nothing(const fs::path &directory)
    {
      return std::ranges::all_of(fs::directory_iterator(directory), [](const fs::directory_entry &entry) {
        return entry.path().filename() == DirectoryLock::file_name;
      });
    }

    /// Empty string, or why the directory cannot be used.
    std::string
    prepare(const fs::path &directory, DirectoryLock &lock)
    {
      if (fs::exists(directory) && !fs::is_directory(directory))
        return "is a file; give a directory that does not exist yet or holds an earlier run";
      if (fs::exists(directory) && !holds_nothing(directory) && !is_output_of_a_run(directory))
        return "is not empty and not the output of a Whipple run (no log.txt of one); nothing overwritten";
      fs::create_directories(directory);
      lock = DirectoryLock(directory);
      for (const char *name :
           {"fields", "fields.xdmf", "error_estimate", "gauges", "last_good_state", "checkpoints", "log.txt",
            "statistics.csv", "history.csv", "summary.json", "parameters.prm", "report.html"})
        fs::remove_all(directory / name);
      // creating it may succeed where writing into it does not; find out now and leave the mark of a run
      std::ofstream log(directory / "log.txt");
      if (!(log << log_mark << '\n' << std::flush))
        return "cannot be written to";
      return {};
    }
  } // namespace

  DirectoryLock
  prepare_output_directory(const std::string &directory, MPI_Comm communicator)
  {
    DirectoryLock lock;
    on_first_rank<InputError>(communicator, [&] {
      std::string reason;
      try
        {
          reason = prepare(directory, lock);
        }
      catch (const fs::filesystem_error &error)
        {
          reason = "cannot be used: " + error.code().message();
        }
      if (!reason.empty())
        throw InputError("output directory '" + directory + "' " + reason);
    });
    return lock;
  }
} // namespace whipple
