// SPDX-License-Identifier: LGPL-2.1-or-later
#pragma once

#include <whipple/mesh/flat_builder.h>

#include <algorithm>
#include <cmath>
#include <unordered_map>
#include <vector>

namespace whipple::projection
{
  /// Finds the leaves that a box overlaps by descending the lattice's levels through integer keys.
  template <int dim>
  class CellTree
  {
  public:
    /// @param keys  leaves that do not overlap
    CellTree(const Lattice<dim> &lattice, const std::vector<CellKey> &keys)
      : lattice_(lattice)
    {
      for (std::size_t i = 0; i < keys.size(); ++i)
        {
          cell_[keys[i]]             = static_cast<Index>(i);
          LatticePoint<dim> ancestor = key_point<dim>(keys[i]);
          for (int level = key_level(keys[i]) - 1; level >= 0; --level)
            {
              for (int &coordinate : ancestor)
                coordinate &= ~(lattice.extent(level) - 1);
              if (!cell_.emplace(make_key<dim>(level, ancestor), none).second)
                break; // from here up all is known
            }
        }
    }

    /// Call visit(index, lower, upper) for every leaf whose box meets [lower, upper]; neighbours share the bits of the
    /// sides they share.
    template <typename Visit>
    void
    for_each_overlap(const Vector<dim> &lower, const Vector<dim> &upper, Visit visit) const
    {
      LatticePoint<dim> first, last;
      const double      edge = lattice_.extent(0) * lattice_.spacing;
      for (int d = 0; d < dim; ++d)
        {
          const double highest = lattice_.roots[d] - 1.;
          first[d] = static_cast<int>(std::clamp(std::floor((lower[d] - lattice_.origin[d]) / edge) - 1., 0., highest));
          last[d]  = static_cast<int>(std::clamp(std::floor((upper[d] - lattice_.origin[d]) / edge) + 1., 0., highest));
        }
      LatticePoint<dim> root = first;
      while (true)
        {
          LatticePoint<dim> point;
          for (int d = 0; d < dim; ++d)
            point[d] = root[d] * lattice_.extent(0);
          descend(0, point, lower, upper, visit);
          int d = 0;
          while (d < dim && ++root[d] > last[d])
            {
              root[d] = first[d];
              ++d;
            }
          if (d == dim)
            return;
        }
    }

    /// Box of a cell of the lattice.
    static void
    box(const Lattice<dim> &lattice, int level, const LatticePoint<dim> &point, Vector<dim> &lower, Vector<dim> &upper)
    {
      for (int d = 0; d < dim; ++d)
        {
          lower[d] = lattice.origin[d] + point[d] * lattice.spacing;
          upper[d] = lattice.origin[d] + (point[d] + lattice.extent(level)) * lattice.spacing;
        }
    }

  private:
    template <typename Visit>
    void
    descend(int level, const LatticePoint<dim> &point, const Vector<dim> &lower, const Vector<dim> &upper,
            Visit &visit) const
    {
      const auto found = cell_.find(make_key<dim>(level, point));
      if (found == cell_.end())
        return;
      Vector<dim> a, b;
      box(lattice_, level, point, a, b);
      for (int d = 0; d < dim; ++d)
        if (a[d] > upper[d] || b[d] < lower[d])
          return;
      if (found->second != none)
        {
          visit(found->second, a, b);
          return;
        }
      for (int c = 0; c < (1 << dim); ++c)
        {
          LatticePoint<dim> child = point;
          for (int d = 0; d < dim; ++d)
            if (c >> d & 1)
              child[d] += lattice_.extent(level + 1);
          descend(level + 1, child, lower, upper, visit);
        }
    }

    Lattice<dim>                       lattice_;
    std::unordered_map<CellKey, Index> cell_; ///< leaf: its index; ancestor of leaves: none
  };
} // namespace whipple::projection
