// SPDX-License-Identifier: LGPL-2.1-or-later
#pragma once

#include <algorithm>
#include <cstddef>
#include <numeric>
#include <utility>
#include <vector>

namespace whipple
{
  /// Sets of the numbers 0 ... n - 1 that grow together. The root of a set is its smallest number, whatever the order
  /// in which it has grown.
  class DisjointSets
  {
  public:
    explicit DisjointSets(std::size_t n)
      : parent_(n)
    {
      std::iota(parent_.begin(), parent_.end(), std::size_t{0});
    }

    std::size_t
    size() const
    {
      return parent_.size();
    }

    std::size_t
    root(std::size_t i) const
    {
      while (parent_[i] != i)
        i = parent_[i];
      return i;
    }

    bool
    is_root(std::size_t i) const
    {
      return parent_[i] == i;
    }

    void
    unite(std::size_t i, std::size_t j)
    {
      i                       = shorten(i);
      j                       = shorten(j);
      parent_[std::max(i, j)] = std::min(i, j);
    }

  private:
    /// The root; what lay on the way there points to it from now on.
    std::size_t
    shorten(std::size_t i)
    {
      const std::size_t top = root(i);
      while (parent_[i] != top)
        i = std::exchange(parent_[i], top);
      return top;
    }

    std::vector<std::size_t> parent_; ///< a smaller number of the same set; of a root: itself
  };
} // namespace whipple
