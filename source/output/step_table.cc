// SPDX-License-Identifier: LGPL-2.1-or-later
#include <whipple/error.h>
#include <whipple/output/first_rank.h>
#include <whipple/output/step_table.h>

#include <array>
#include <cerrno>
#include <charconv>
#include <cstring>
#include <filesystem>
#include <system_error>

namespace whipple
{
  namespace
  {
    /// Shortest text that reads back as the same bits.
    void
    print(std::ostream &out, double value)
    {
      std::array<char, 32> text;
      const auto           end = std::to_chars(text.data(), text.data() + text.size(), value).ptr;
      out.write(text.data(), end - text.data());
    }

    /// Cut a table back to what stands. @returns its columns
    std::vector<std::string>
    cut_back(const std::string &path, std::uint64_t bytes)
    {
      std::error_code     failure;
      const std::uint64_t present = std::filesystem::file_size(path, failure);
      if (failure || present < bytes)
        throw InputError(path + ": is shorter than the " + std::to_string(bytes) + " bytes that were written to it");
      std::filesystem::resize_file(path, bytes);
      std::ifstream            file(path);
      std::string              line, name;
      std::vector<std::string> columns;
      std::getline(file, line);
      for (std::istringstream names(line); std::getline(names, name, ',');)
        columns.push_back(name);
      return columns;
    }
  } // namespace

  StepTable::StepTable(const std::string &path, MPI_Comm communicator, std::uint64_t kept)
    : path_(path)
    , active_(is_first_rank(communicator))
  {
    on_first_rank<InputError>(communicator, [&] {
      if (kept > 0)
        {
          columns_ = cut_back(path, kept);
          kept_    = kept;
        }
      file_.open(path, kept > 0 ? std::ios::app : std::ios::trunc);
      if (!file_)
        throw InputError(path + ": cannot be written");
    });
  }

  void
  StepTable::write(std::span<const TableEntry> row)
  {
    if (!active_)
      return;
    if (columns_.empty())
      {
        for (const TableEntry &entry : row)
          {
            file_ << (columns_.empty() ? "" : ",") << entry.name;
            kept_ += entry.name.size() + 1; // with the comma or line end behind it
            columns_.emplace_back(entry.name);
          }
        file_ << '\n';
      }
    if (row.size() != columns_.size())
      throw Error(path_ + ": a row of " + std::to_string(row.size()) + " values in a table of " +
                  std::to_string(columns_.size()) + " columns");
    for (std::size_t i = 0; i < row.size(); ++i)
      {
        if (row[i].name != columns_[i])
          throw Error(path_ + ": value '" + std::string(row[i].name) + "' in column '" + columns_[i] + "'");
        if (i > 0)
          waiting_ << ',';
        if (const double *number = std::get_if<double>(&row[i].value))
          print(waiting_, *number);
        else
          waiting_ << std::get<std::string_view>(row[i].value);
      }
    waiting_ << '\n';
  }

  void
  StepTable::keep()
  {
    if (active_)
      {
        const std::string rows = waiting_.str();
        file_ << rows;
        kept_ += rows.size();
        check();
      }
    forget();
  }

  void
  StepTable::forget()
  {
    waiting_.str({});
  }

  void
  StepTable::flush()
  {
    if (!active_)
      return;
    file_.flush();
    check();
  }

  void
  StepTable::check() const
  {
    if (!file_)
      throw Error(path_ + ": cannot be written: " + std::strerror(errno));
  }
} // namespace whipple
