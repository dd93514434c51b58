// SPDX-License-Identifier: LGPL-2.1-or-later
#pragma once

#include <array>
#include <span>
#include <vector>

namespace whipple
{
  /// A cell of the mesh that holds material of a plate. Places are in finest cells of the lattice; all shares are those
  /// of the plate's own material (doc/theory/measures.md, "The image").
  struct PlateCell
  {
    std::array<int, 2> lower{};
    int                size  = 1;
    double             fill  = 0;    ///< F: share of the cell's volume, pores included
    double             solid = 0;    ///< S: the same without the pores that the material did not have when it entered
    double             mass  = 0;    ///< g
    bool               dense = true; ///< at least half as dense as when it entered: plate or chunk, not debris cloud

    int
    upper(int axis) const
    {
      return lower[axis] + size;
    }
  };

  /// The cells that hold a plate's material, wherever they are, with the order along lines in which surfaces are looked
  /// for. Memory: one number for each line through each cell, nothing for empty space.
  class PlateImage
  {
  public:
    /// @param cells do not overlap; any order
    explicit PlateImage(std::vector<PlateCell> cells);

    /// By place: the order does not depend on the one they came in.
    const std::vector<PlateCell> &
    cells() const
    {
      return cells_;
    }

    /// First line along an axis and the one after the last: coordinates of the other axis.
    std::array<int, 2>
    lines(int axis) const
    {
      return {{lines_[axis].first, lines_[axis].first + static_cast<int>(lines_[axis].begin.size()) - 1}};
    }

    /// Indices of the cells on a line along an axis, in ascending order; none outside lines(axis).
    std::span<const int>
    line(int axis, int coordinate) const;

    /// Call visit(a, b) for every two cells that share a face or a corner, some more than once.
    template <typename Visit>
    void
    for_each_contact(const Visit &visit) const
    {
      const auto [first, last] = lines(1);
      for (int column = first; column < last; ++column)
        {
          const std::span<const int> here = line(1, column), next = line(1, column + 1);
          for (std::size_t k = 0; k + 1 < here.size(); ++k)
            if (cells_[here[k]].upper(1) == cells_[here[k + 1]].lower[1])
              visit(here[k], here[k + 1]);
          std::size_t start = 0;
          for (const int a : here)
            {
              while (start < next.size() && cells_[next[start]].upper(1) < cells_[a].lower[1])
                ++start;
              for (std::size_t k = start; k < next.size() && cells_[next[k]].lower[1] <= cells_[a].upper(1); ++k)
                if (next[k] != a)
                  visit(a, next[k]);
            }
        }
    }

  private:
    struct Lines
    {
      int                      first = 0;
      std::vector<std::size_t> begin{0}; ///< into `cell`, line by line, and its end
      std::vector<int>         cell;
    };

    Lines
    lines_along(int axis) const;

    std::vector<PlateCell> cells_;
    std::array<Lines, 2>   lines_;
  };
} // namespace whipple
