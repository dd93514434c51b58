// SPDX-License-Identifier: LGPL-2.1-or-later
#pragma once

#include <whipple/mesh/index.h>

#include <array>
#include <vector>

namespace whipple
{
  /// A material in a cell that is to be cut: its true volume and the out-of-material normal of its interface
  /// (zero: no interface, the material is spread evenly).
  template <int dim>
  struct MaterialInCell
  {
    double      volume = 0;
    Vector<dim> normal{};
  };

  /// Share of each material's volume in each of the 2^dim halves-of-edge children of a square cell; the shares of a
  /// material add up to 1 (to 0 for one that is not there).
  ///
  /// Each material lies below its own plane. Where these planes would put more into a child than it has room
  /// for, all materials are cut by planes parallel to the first interface, stacked in the order of the
  /// materials with the open void outermost. Cells that are overfull are cut evenly. Shares below 1e-13 are
  /// left to the other children.
  /// @param lower, size  box of the cell, cm
  template <int dim>
  std::vector<std::array<double, 1 << dim>>
  child_shares(Symmetry symmetry, const Vector<dim> &lower, double size,
               const std::vector<MaterialInCell<dim>> &materials);

  /// True volumes of the children.
  template <int dim>
  std::array<double, 1 << dim>
  child_volumes(Symmetry symmetry, const Vector<dim> &lower, double size);
} // namespace whipple
