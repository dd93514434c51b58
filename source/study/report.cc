// SPDX-License-Identifier: LGPL-2.1-or-later
#include <whipple/error.h>
#include <whipple/study/report.h>

#include <filesystem>
#include <fstream>

namespace whipple::report
{
  namespace
  {
    /// Whoever looks sees the old file or the new one, never a part.
    void
    write_file(const std::filesystem::path &path, const std::string &text)
    {
      const std::filesystem::path temporary = path.string() + ".part";
      {
        std::ofstream file(temporary);
        if (!(file << text << std::flush))
          throw Error(temporary.string() + ": cannot be written");
      }
      std::filesystem::rename(temporary, path);
    }
  } // namespace

  void
  write(const StudyReport &report)
  {
    const std::filesystem::path directory = report.options.output_directory;
    write_file(directory / "study.csv", csv(report));
    write_file(directory / "study.md", markdown(report));
    write_file(directory / "study.json", json(report));
  }
} // namespace whipple::report
