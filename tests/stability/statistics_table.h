// SPDX-License-Identifier: LGPL-2.1-or-later
#pragma once

#include <cstdlib>
#include <fstream>
#include <limits>
#include <map>
#include <sstream>
#include <stdexcept>
#include <string>
#include <vector>

namespace whipple::stability
{
  /// statistics.csv of a run: column by its name without the unit -> values of all steps.
  class StatisticsTable
  {
  public:
    StatisticsTable() = default;
    explicit StatisticsTable(const std::string &file)
    {
      std::ifstream            in(file);
      std::string              line;
      std::vector<std::string> names;
      for (bool first = true; std::getline(in, line); first = false)
        {
          std::stringstream row(line);
          std::string       entry;
          for (std::size_t i = 0; std::getline(row, entry, ','); ++i)
            if (first)
              names.push_back(entry.substr(0, entry.find(" [")));
            else
              columns_[names.at(i)].push_back(number(entry));
        }
    }

    /// @throws std::out_of_range if there is no such column or no step was taken.
    const std::vector<double> &
    operator[](const std::string &name) const
    {
      const auto found = columns_.find(name);
      if (found == columns_.end())
        throw std::out_of_range("no column '" + name + "' in statistics.csv");
      return found->second;
    }

  private:
    /// Columns of words hold no numbers.
    static double
    number(const std::string &entry)
    {
      char        *end   = nullptr;
      const double value = std::strtod(entry.c_str(), &end);
      return end == entry.c_str() ? std::numeric_limits<double>::quiet_NaN() : value;
    }

    std::map<std::string, std::vector<double>> columns_;
  };
} // namespace whipple::stability
