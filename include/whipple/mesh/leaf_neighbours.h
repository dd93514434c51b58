// SPDX-License-Identifier: LGPL-2.1-or-later
#pragma once

#include <whipple/mesh/key_arithmetic.h>
#include <whipple/mesh/key_index.h>

namespace whipple
{
  /// Calls `visit(index)` for every cell of `cells` that touches the cell `key` in a face, an edge or a corner.
  /// The cells must be 2:1 balanced over corners; they may leave holes. A coarser cell that touches in several
  /// directions is visited as often.
  template <int dim, class Visit>
  void
  for_each_touching(const Lattice<dim> &lattice, const KeyIndex &cells, CellKey key, const Visit &visit)
  {
    constexpr int           directions = dim == 2 ? 9 : 27;
    const int               level      = key_level(key);
    const LatticePoint<dim> point      = key_point<dim>(key);
    for (int direction = 0; direction < directions; ++direction)
      {
        std::array<int, dim> offset;
        LatticePoint<dim>    position;
        bool                 inside = true;
        for (int d = 0, rest = direction; d < dim; ++d, rest /= 3)
          {
            offset[d]   = rest % 3 - 1;
            position[d] = point[d] + offset[d] * lattice.extent(level);
            inside      = inside && position[d] >= 0 && position[d] < lattice.finest(d);
          }
        if (!inside || direction == directions / 2)
          continue;
        const CellKey same = make_key<dim>(level, position);
        Index         cell = cells.find(same);
        if (cell == none && level > 0)
          cell = cells.find(ancestor_key(lattice, same, level - 1));
        if (cell != none)
          {
            visit(cell);
            continue;
          }
        if (level == lattice.max_level)
          continue;
        for (int child = 0; child < (1 << dim); ++child)
          {
            bool touches = true;
            for (int d = 0; d < dim; ++d)
              touches = touches && offset[d] != (((child >> d) & 1) ? 1 : -1);
            if (!touches)
              continue;
            const Index finer = cells.find(child_key(lattice, same, child));
            if (finer != none)
              visit(finer);
          }
      }
  }
} // namespace whipple
