// SPDX-License-Identifier: LGPL-2.1-or-later
#include <whipple/material/bicubic_table.h>

#include <algorithm>
#include <cmath>
#include <limits>
#include <utility>

namespace whipple
{
  namespace
  {
    /// Largest slope, in units of the smaller neighbouring secant: in x the cubic is monotone, in y its Bezier polygon
    /// too, so that a mean of two grid lines of x is monotone in y.
    constexpr double limit_x = 3., limit_y = 1.5;
  } // namespace

  BicubicTable::BicubicTable(std::vector<double> x, std::vector<double> y, const std::vector<double> &values)
    : x_(std::move(x))
    , y_(std::move(y))
    , nodes_(values.size())
  {
    const std::size_t   nx = x_.size(), ny = y_.size();
    std::vector<double> column(nx), twist(nx);
    for (std::size_t i = 0; i < nx; ++i)
      {
        const std::span<const double> row    = std::span(values).subspan(i * ny, ny);
        const std::vector<double>     slopes = monotone_slopes(y_, row, limit_y);
        for (std::size_t j = 0; j < ny; ++j)
          nodes_[i * ny + j] = {row[j], 0., slopes[j], 0.};
      }
    for (std::size_t j = 0; j < ny; ++j)
      {
        for (std::size_t i = 0; i < nx; ++i)
          {
            column[i] = node(i, j).f;
            twist[i]  = node(i, j).fy;
          }
        const std::vector<double> slopes = monotone_slopes(x_, column, limit_x);
        const std::vector<double> twists = monotone_slopes(x_, twist, limit_x);
        for (std::size_t i = 0; i < nx; ++i)
          {
            nodes_[i * ny + j].fx  = slopes[i];
            nodes_[i * ny + j].fxy = twists[i];
          }
      }
  }

  double
  BicubicTable::find_y_within(double x, double value, std::size_t j) const
  {
    Cell       cell{0, j};
    const auto f   = [&](double y) { return at(x, y, cell); };
    double     low = y_[j], high = y_[j + 1];
    const bool rises = f(high).value > f(low).value;
    // Newton, kept between bounds that bisection tightens
    double y = 0.5 * (low + high);
    for (int i = 0; i < 200 && high > std::nextafter(low, high); ++i)
      {
        const Point p                             = f(y);
        ((p.value < value) == rises ? low : high) = y;
        const double newton                       = y - (p.value - value) / p.dy;
        if (std::abs(newton - y) <= std::numeric_limits<double>::epsilon() * std::abs(y))
          return newton;
        // every third step halves the bracket, so that it shrinks where Newton comes from one side only
        y = i % 3 < 2 && newton > low && newton < high ? newton : low + 0.5 * (high - low);
      }
    return high;
  }

  std::optional<double>
  BicubicTable::find_y(double x, double value, double near) const
  {
    std::optional<double> best;
    const auto            offer = [&](double y) {
      if (!best || std::abs(y - near) < std::abs(*best - near))
        best = y;
    };
    Cell  cell;
    Point low = at(x, y_.front(), cell);
    if (const double y = y_.front() + (value - low.value) / low.dy; y < y_.front())
      offer(y);
    for (std::size_t j = 0; j + 1 < y_.size(); ++j)
      {
        const Point high = at(x, y_[j + 1], cell);
        if (low.value == value && high.value == value)
          offer(std::clamp(near, y_[j], y_[j + 1]));
        else if (low.value == value)
          offer(y_[j]);
        else if (high.value == value)
          offer(y_[j + 1]);
        else if ((low.value < value) != (high.value < value))
          offer(find_y_within(x, value, j));
        low = high;
      }
    if (const double y = y_.back() + (value - low.value) / low.dy; y > y_.back())
      offer(y);
    return best;
  }
} // namespace whipple
