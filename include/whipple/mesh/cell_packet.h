// SPDX-License-Identifier: LGPL-2.1-or-later
#pragma once

#include <whipple/mesh/flat_builder.h>

#include <array>
#include <functional>
#include <vector>

namespace whipple
{
  /// Everything one leaf holds, flattened to doubles so that the forest can carry it between ranks and
  /// levels without knowing what it is. Empty: the leaf holds no material.
  using CellPacket = std::vector<double>;

  /// What refinement and coarsening do to packets (conservative remaps; remap/cell_split.h).
  template <int dim>
  struct PacketRemap
  {
    using Children = std::array<CellPacket, 1 << dim>; ///< lexicographic
    std::function<Children(CellKey parent, const CellPacket &packet)>   split;
    std::function<CellPacket(CellKey parent, const Children &children)> merge;
  };
} // namespace whipple
