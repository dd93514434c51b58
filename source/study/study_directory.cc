// SPDX-License-Identifier: LGPL-2.1-or-later
#include <whipple/error.h>
#include <whipple/study/study_directory.h>

#include <filesystem>
#include <fstream>

namespace whipple
{
  namespace
  {
    namespace fs = std::filesystem;

    constexpr const char *mark_file = "study.txt";
    constexpr const char *mark      = "Whipple study ";

    /// Path of the study file that the directory belongs to; empty if to none.
    std::string
    owner(const fs::path &directory)
    {
      std::ifstream file(directory / mark_file);
      std::string   line;
      if (!std::getline(file, line) || !line.starts_with(mark))
        return {};
      return line.substr(std::string(mark).size());
    }

    DirectoryLock
    prepare(const fs::path &directory, const std::string &study_file)
    {
      const std::string shown = "output directory '" + directory.string() + "' ";
      if (fs::exists(directory) && !fs::is_directory(directory))
        throw InputError(shown + "is a file; give a directory that does not exist yet or holds this study");
      if (fs::exists(directory) && !fs::is_empty(directory))
        {
          const std::string other = owner(directory);
          if (other.empty())
            throw InputError(shown + "is not empty and not the output of a study (no " + mark_file +
                             " of one); nothing overwritten, give another --output");
          if (other != study_file)
            throw InputError(shown + "belongs to another study, " + other +
                             "; nothing overwritten, give another --output");
          return DirectoryLock(directory);
        }
      fs::create_directories(directory);
      DirectoryLock lock(directory);
      std::ofstream file(directory / mark_file);
      if (!(file << mark << study_file << '\n' << std::flush))
        throw InputError(shown + "cannot be written to");
      return lock;
    }

    std::string
    point_path(const std::string &directory, const std::string &label, int repeat)
    {
      return (fs::path(directory) / "points" / label).string() +
             (repeat == 0 ? "" : " repeat " + std::to_string(repeat + 1));
    }
  } // namespace

  DirectoryLock
  prepare_study_directory(const std::string &directory, const std::string &study_file)
  {
    try
      {
        return prepare(directory, fs::canonical(study_file));
      }
    catch (const fs::filesystem_error &error)
      {
        throw InputError("output directory '" + directory + "' cannot be used: " + error.code().message());
      }
  }

  std::string
  point_directory(const std::string &directory, const std::string &label, int repeat)
  {
    return point_path(directory, label, repeat);
  }

  std::string
  point_log(const std::string &directory, const std::string &label, int repeat)
  {
    return point_path(directory, label, repeat) + ".txt";
  }
} // namespace whipple
