// SPDX-License-Identifier: LGPL-2.1-or-later
#include <whipple/material/cubic_table.h>

#include <stdexcept>

namespace whipple
{
  CubicTable::CubicTable(double lower, double upper, const std::vector<Node> &nodes)
    : lower_(lower)
    , upper_(upper)
    , intervals_(static_cast<int>(nodes.size()) - 1)
  {
    if (!(intervals_ >= 1 && lower < upper))
      throw std::logic_error("a table needs two nodes and a range");
    const double spacing = (upper - lower) / intervals_;
    per_interval_        = 1. / spacing;
    coefficients_.reserve(4 * intervals_);
    for (int i = 0; i < intervals_; ++i)
      {
        const double rise  = nodes[i + 1].value - nodes[i].value;
        const double left  = spacing * nodes[i].slope;
        const double right = spacing * nodes[i + 1].slope;
        for (const double c : {nodes[i].value, left, 3. * rise - 2. * left - right, left + right - 2. * rise})
          coefficients_.push_back(c);
      }
  }
} // namespace whipple
