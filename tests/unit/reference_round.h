// SPDX-License-Identifier: LGPL-2.1-or-later
#pragma once

#include <whipple/mesh/flat_builder.h>

#include <algorithm>
#include <vector>

/// One round of adaptation in 2D, by exhaustion: independent of the code under test, quadratic in the number of
/// leaves, from the definition in doc/theory/mesh.md alone.
namespace reference
{
  struct Leaf
  {
    int level, x, y, target;
  };

  inline bool
  touch(const whipple::Lattice<2> &lattice, const Leaf &a, const Leaf &b)
  {
    const int ea = lattice.extent(a.level), eb = lattice.extent(b.level);
    return a.x <= b.x + eb && b.x <= a.x + ea && a.y <= b.y + eb && b.y <= a.y + ea;
  }

  /// Siblings of a leaf among all leaves, itself included.
  inline std::vector<std::size_t>
  siblings(const whipple::Lattice<2> &lattice, const std::vector<Leaf> &leaves, std::size_t i)
  {
    std::vector<std::size_t> result;
    const int                parent = 2 * lattice.extent(leaves[i].level);
    for (std::size_t j = 0; j < leaves.size(); ++j)
      if (leaves[j].level == leaves[i].level && leaves[j].x / parent == leaves[i].x / parent &&
          leaves[j].y / parent == leaves[i].y / parent)
        result.push_back(j);
    return result;
  }

  /// Sorted keys of the leaves after one round.
  inline std::vector<whipple::CellKey>
  round(const whipple::Lattice<2> &lattice, const std::vector<Leaf> &leaves)
  {
    std::vector<int> level(leaves.size());
    for (std::size_t i = 0; i < leaves.size(); ++i)
      level[i] = std::clamp(leaves[i].target, leaves[i].level - 1, leaves[i].level + 1);

    for (bool changed = true; changed;)
      {
        changed = false;
        for (std::size_t i = 0; i < leaves.size(); ++i)
          {
            if (level[i] < leaves[i].level)
              {
                const auto family = siblings(lattice, leaves, i);
                bool       agreed = family.size() == 4;
                for (const std::size_t s : family)
                  agreed = agreed && level[s] < leaves[s].level;
                for (std::size_t j = 0; j < leaves.size(); ++j)
                  if (touch(lattice, leaves[i], leaves[j]))
                    agreed = agreed && leaves[j].level <= leaves[i].level;
                if (!agreed)
                  {
                    level[i] = leaves[i].level;
                    changed  = true;
                  }
              }
            for (std::size_t j = 0; j < leaves.size(); ++j)
              if (level[j] > level[i] + 1 && touch(lattice, leaves[i], leaves[j]))
                {
                  ++level[i];
                  changed = true;
                }
          }
      }

    std::vector<whipple::CellKey> result;
    for (std::size_t i = 0; i < leaves.size(); ++i)
      {
        const auto [present, x, y, target] = leaves[i];
        const int parent                   = 2 * lattice.extent(present);
        if (level[i] > present)
          for (int k = 0; k < 4; ++k)
            result.push_back(
                whipple::make_key<2>(present + 1, {{x + (k & 1) * parent / 4, y + (k >> 1) * parent / 4}}));
        else if (level[i] == present)
          result.push_back(whipple::make_key<2>(present, {{x, y}}));
        else
          result.push_back(whipple::make_key<2>(present - 1, {{x / parent * parent, y / parent * parent}}));
      }
    std::sort(result.begin(), result.end());
    result.erase(std::unique(result.begin(), result.end()), result.end());
    return result;
  }
} // namespace reference
