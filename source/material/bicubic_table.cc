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
    /// too.
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
    make_rising();
  }

  bool
  BicubicTable::rises(std::size_t i, std::size_t j, int side) const
  {
    const Node  &a = node(i + side, j), &b = node(i + side, j + 1);
    const double third_x = (side == 0 ? 1. : -1.) * (x_[i + 1] - x_[i]) / 3., third_y = (y_[j + 1] - y_[j]) / 3.;
    const double first = third_y * (a.fy + third_x * a.fxy), last = third_y * (b.fy + third_x * b.fxy);
    const double middle = b.f - a.f + third_x * (b.fx - a.fx) - first - last;
    // below that, a fall is rounding
    const double rounding =
        -1e-13 * (std::abs(a.f) + std::abs(b.f) + std::abs(third_x) * (std::abs(a.fx) + std::abs(b.fx)));
    return first >= rounding && middle >= rounding && last >= rounding;
  }

  void
  BicubicTable::make_rising()
  {
    // With f_x = f_xy = 0 the net rises (limit_y); the last passes set them to that.
    constexpr int most_passes = 40;
    bool          changed     = true;
    for (int pass = 0; changed; ++pass)
      {
        changed = false;
        for (std::size_t i = 0; i + 1 < x_.size(); ++i)
          for (std::size_t j = 0; j + 1 < y_.size(); ++j)
            {
              if (node(i, j + 1).f < node(i, j).f || node(i + 1, j + 1).f < node(i + 1, j).f)
                continue;
              for (int side = 0; side < 2; ++side)
                if (!rises(i, j, side))
                  {
                    changed = true;
                    for (std::size_t k = j; k <= j + 1; ++k)
                      {
                        Node &corner = nodes_[(i + side) * y_.size() + k];
                        corner.fx *= pass < most_passes ? 0.5 : 0.;
                        corner.fxy *= pass < most_passes ? 0.5 : 0.;
                      }
                  }
            }
      }
  }

  std::optional<double>
  BicubicTable::find_y(double x, double value) const
  {
    Cell       cell;
    const auto f      = [&](double y) { return at(x, y, cell); };
    const auto beyond = [&](double edge) -> std::optional<double> {
      const Point p = f(edge);
      return p.dy > 0. ? std::optional(edge + (value - p.value) / p.dy) : std::nullopt;
    };
    double low = y_.front(), high = y_.back();
    if (value == f(low).value)
      return low;
    if (value < f(low).value)
      return beyond(low);
    if (value > f(high).value)
      return beyond(high);
    // f(low) < value <= f(high): Newton, kept between bounds that bisection tightens
    double y = 0.5 * (low + high);
    for (int i = 0; i < 200 && high > std::nextafter(low, high); ++i)
      {
        const Point p                  = f(y);
        (p.value < value ? low : high) = y;
        const double newton            = y - (p.value - value) / p.dy;
        if (std::abs(newton - y) <= std::numeric_limits<double>::epsilon() * std::abs(y))
          return newton;
        // every third step halves the bracket, so that it shrinks where Newton comes from one side only
        y = i % 3 < 2 && newton > low && newton < high ? newton : low + 0.5 * (high - low);
      }
    return high;
  }
} // namespace whipple
