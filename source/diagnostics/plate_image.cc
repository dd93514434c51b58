// SPDX-License-Identifier: LGPL-2.1-or-later
#include <whipple/diagnostics/plate_image.h>

#include <algorithm>
#include <numeric>

namespace whipple
{
  PlateImage::PlateImage(std::vector<PlateCell> cells)
    : cells_(std::move(cells))
  {
    std::sort(cells_.begin(), cells_.end(), [](const PlateCell &a, const PlateCell &b) { return a.lower < b.lower; });
    for (int axis = 0; axis < 2; ++axis)
      lines_[axis] = lines_along(axis);
  }

  PlateImage::Lines
  PlateImage::lines_along(int axis) const
  {
    Lines result;
    if (cells_.empty())
      return result;
    const int across = 1 - axis;
    int       last   = cells_.front().upper(across);
    result.first     = cells_.front().lower[across];
    for (const PlateCell &cell : cells_)
      {
        result.first = std::min(result.first, cell.lower[across]);
        last         = std::max(last, cell.upper(across));
      }
    std::vector<int> order(cells_.size());
    std::iota(order.begin(), order.end(), 0);
    std::sort(order.begin(), order.end(), [&](int a, int b) {
      const PlateCell &p = cells_[a], &q = cells_[b];
      return p.lower[axis] != q.lower[axis] ? p.lower[axis] < q.lower[axis] : p.lower[across] < q.lower[across];
    });

    result.begin.assign(last - result.first + 1, 0);
    for (const PlateCell &cell : cells_)
      for (int k = cell.lower[across]; k < cell.upper(across); ++k)
        ++result.begin[k - result.first + 1];
    std::partial_sum(result.begin.begin(), result.begin.end(), result.begin.begin());
    result.cell.resize(result.begin.back());
    std::vector<std::size_t> next(result.begin.begin(), result.begin.end() - 1);
    for (const int c : order)
      for (int k = cells_[c].lower[across]; k < cells_[c].upper(across); ++k)
        result.cell[next[k - result.first]++] = c;
    return result;
  }

  std::span<const int>
  PlateImage::line(int axis, int coordinate) const
  {
    const Lines &all = lines_[axis];
    if (coordinate < lines(axis)[0] || coordinate >= lines(axis)[1])
      return {};
    const std::size_t k = coordinate - all.first;
    return std::span<const int>(all.cell).subspan(all.begin[k], all.begin[k + 1] - all.begin[k]);
  }
} // namespace whipple
