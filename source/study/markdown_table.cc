// SPDX-License-Identifier: LGPL-2.1-or-later
#include <whipple/scene/units.h>
#include <whipple/study/markdown_table.h>

namespace whipple::report
{
  std::string
  cell_text(double cell)
  {
    return units::format(cell, units::length);
  }

  std::string
  head(const std::vector<std::string> &columns)
  {
    std::string names = "|", rule = "|";
    for (const std::string &column : columns)
      {
        names += ' ' + column + " |";
        rule += "---|";
      }
    return names + '\n' + rule + '\n';
  }

  std::string
  row(const std::vector<std::string> &cells)
  {
    std::string text = "|";
    for (const std::string &cell : cells)
      text += ' ' + cell + " |";
    return text + '\n';
  }
} // namespace whipple::report
