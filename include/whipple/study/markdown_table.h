// SPDX-License-Identifier: LGPL-2.1-or-later
#pragma once

#include <string>
#include <vector>

/// Pieces of the tables of study.md.
namespace whipple::report
{
  /// A table's head and the line below it.
  std::string
  head(const std::vector<std::string> &columns);

  /// A line of a table.
  std::string
  row(const std::vector<std::string> &cells);

  /// A cell size, "0.008 cm".
  std::string
  cell_text(double cell);
} // namespace whipple::report
