// SPDX-License-Identifier: LGPL-2.1-or-later
#pragma once

#include <whipple/error.h>
#include <whipple/mesh/flat_builder.h>

#include <string>

namespace whipple
{
  /// @throws InputError if coordinates or levels of the lattice do not fit into cell keys, or there is no cell.
  template <int dim>
  void
  require_packable(const Lattice<dim> &lattice)
  {
    constexpr int limit = 1 << 19;
    for (int d = 0; d < dim; ++d)
      if (lattice.max_level < 0 || lattice.max_level > 18 || lattice.roots[d] < 1 ||
          lattice.roots[d] > (limit >> lattice.max_level))
        throw InputError("mesh of " + std::to_string(lattice.roots[d]) + " root cells along axis " + std::to_string(d) +
                         " refined " + std::to_string(lattice.max_level) +
                         " times: needs at least 1 root cell and at most " + std::to_string(limit) +
                         " finest cells along each axis");
  }

  /// Key of the cell of a coarser (or the same) level that contains this cell.
  template <int dim>
  CellKey
  ancestor_key(const Lattice<dim> &lattice, CellKey key, int level)
  {
    LatticePoint<dim> point = key_point<dim>(key);
    for (int d = 0; d < dim; ++d)
      point[d] &= ~(lattice.extent(level) - 1);
    return make_key<dim>(level, point);
  }

  /// Key of a child; bit d of `child` = upper half along axis d.
  template <int dim>
  CellKey
  child_key(const Lattice<dim> &lattice, CellKey key, int child)
  {
    const int         level = key_level(key) + 1;
    LatticePoint<dim> point = key_point<dim>(key);
    for (int d = 0; d < dim; ++d)
      point[d] += ((child >> d) & 1) * lattice.extent(level);
    return make_key<dim>(level, point);
  }
} // namespace whipple
