// SPDX-License-Identifier: LGPL-2.1-or-later
#include <whipple/error.h>
#include <whipple/output/first_rank.h>
#include <whipple/output/manifest.h>
#include <whipple/output/output_directory.h>

#include <algorithm>
#include <filesystem>
#include <fstream>

namespace whipple
{
  namespace
  {
    namespace fs = std::filesystem;

    constexpr const char *log_file = "log.txt";
    /// Its first line starts with this (see RunLog::banner).
    constexpr const char *log_mark = "Whipple";

    bool
    is_output_of_a_run(const fs::path &directory)
    {
      std::ifstream log(directory / log_file);
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
    prepare(const fs::path &directory, EarlierRun earlier, DirectoryLock &lock)
    {
      if (fs::exists(directory) && !fs::is_directory(directory))
        return "is a file; give a directory that does not exist yet or holds an earlier run";
      if (fs::exists(directory) && !holds_nothing(directory) && !is_output_of_a_run(directory))
        return "is not empty and not the output of a Whipple run (no log.txt of one); nothing overwritten";
      fs::create_directories(directory);
      lock = DirectoryLock(directory);
      if (is_output_of_a_run(directory))
        {
          if (earlier == EarlierRun::refused)
            return "holds an earlier run; give another directory, or --overwrite to replace that run";
          manifest::remove_listed(directory);
        }
      // creating it may succeed where writing into it does not; find out now and leave the mark of a run
      std::ofstream log(directory / log_file);
      if (!(log << log_mark << '\n' << std::flush))
        return "cannot be written to";
      for (const char *name : {log_file, "parameters.prm", "summary.json", "statistics.csv", "fields.xdmf",
                               "fields.pvd", "report.html", "checkpoints/", "last_good_state/"})
        manifest::note(directory, name);
      return {};
    }
  } // namespace

  std::string
  free_output_directory(const std::string &asked)
  {
    std::error_code failure; // what cannot be looked at is refused when it is prepared
    const auto      is_taken = [&failure](const std::string &directory) {
      return fs::is_directory(directory, failure) && is_output_of_a_run(directory);
    };
    if (!is_taken(asked) || DirectoryLock::is_held(asked))
      return asked;
    std::string stem = asked;
    while (stem.size() > 1 && stem.ends_with('/'))
      stem.pop_back();
    for (int number = 2;; ++number)
      {
        const std::string other = stem + '-' + std::to_string(number);
        if (!fs::exists(other, failure) || (fs::is_directory(other, failure) && holds_nothing(other)))
          return other;
      }
  }

  DirectoryLock
  prepare_output_directory(const std::string &directory, EarlierRun earlier, MPI_Comm communicator)
  {
    DirectoryLock lock;
    on_first_rank<InputError>(communicator, [&] {
      std::string reason;
      try
        {
          reason = prepare(directory, earlier, lock);
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
