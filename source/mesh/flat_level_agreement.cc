// SPDX-License-Identifier: LGPL-2.1-or-later
#include <whipple/error.h>
#include <whipple/mesh/leaf_neighbours.h>
#include <whipple/mesh/level_agreement.h>

#include <algorithm>
#include <string>

namespace whipple
{
  namespace
  {
    /// Leaves with what the agreement asks about them.
    template <int dim>
    struct Leaves
    {
      static constexpr int children = 1 << dim;

      const Lattice<dim>      &lattice;
      std::span<const CellKey> key;
      KeyIndex                 index;
      std::vector<Index>       family; ///< first sibling of a complete family of leaves, else `none`

      Leaves(const Lattice<dim> &lattice_, std::span<const CellKey> key_)
        : lattice(lattice_)
        , key(key_)
        , index(key_)
        , family(key_.size(), none)
      {
        // siblings are adjacent in forest order: a family is 2^dim leaves in a row below one parent
        for (std::size_t i = 0; i + children <= key.size();)
          {
            const int level  = key_level(key[i]);
            int       inside = 0;
            if (level > 0)
              {
                const CellKey parent = ancestor_key(lattice, key[i], level - 1);
                while (inside < children && key[i + inside] == child_key(lattice, parent, inside))
                  ++inside;
              }
            if (inside == children)
              for (int k = 0; k < children; ++k)
                family[i + k] = static_cast<Index>(i);
            i += inside == children ? children : 1;
          }
      }
    };

    template <int dim>
    std::vector<std::uint8_t>
    wanted_levels(const Lattice<dim> &lattice, std::span<const CellKey> leaves, std::span<const std::uint8_t> target)
    {
      std::vector<std::uint8_t> wanted(leaves.size());
      for (std::size_t i = 0; i < leaves.size(); ++i)
        {
          if (target[i] > lattice.max_level)
            throw StateError("target level " + std::to_string(target[i]) + " of a leaf exceeds the finest level " +
                             std::to_string(lattice.max_level));
          const int level = key_level(leaves[i]);
          wanted[i]       = static_cast<std::uint8_t>(std::clamp<int>(target[i], level - 1, level + 1));
        }
      return wanted;
    }

    /// Take back every coarsening that its siblings do not share or that a finer neighbour forbids.
    template <int dim>
    void
    cancel_coarsening(const Leaves<dim> &leaves, std::vector<std::uint8_t> &wanted)
    {
      const Index n = static_cast<Index>(wanted.size());
      for (Index i = 0; i < n;)
        {
          const int level = key_level(leaves.key[i]);
          if (leaves.family[i] == none)
            {
              wanted[i] = std::max<std::uint8_t>(wanted[i], level);
              ++i;
              continue;
            }
          bool coarsen = true;
          for (int k = 0; k < leaves.children; ++k)
            coarsen = coarsen && wanted[i + k] < level;
          for (int k = 0; k < leaves.children && coarsen; ++k)
            for_each_touching(leaves.lattice, leaves.index, leaves.key[i + k],
                              [&](Index other) { coarsen = coarsen && key_level(leaves.key[other]) <= level; });
          if (!coarsen)
            for (int k = 0; k < leaves.children; ++k)
              wanted[i + k] = std::max<std::uint8_t>(wanted[i + k], level);
          i += leaves.children;
        }
    }

    /// Raise what touches a refined leaf. Only refinement spreads: a cancelled coarsening leaves levels as they
    /// are, and those are balanced.
    template <int dim>
    void
    spread_refinement(const Leaves<dim> &leaves, std::vector<std::uint8_t> &wanted)
    {
      std::vector<Index> refined;
      for (std::size_t i = 0; i < wanted.size(); ++i)
        if (wanted[i] > key_level(leaves.key[i]))
          refined.push_back(static_cast<Index>(i));
      while (!refined.empty())
        {
          const CellKey key   = leaves.key[refined.back()];
          const int     level = key_level(key);
          refined.pop_back();
          for_each_touching(leaves.lattice, leaves.index, key, [&](Index other) {
            if (wanted[other] >= level)
              return;
            const int present = key_level(leaves.key[other]);
            if (present < level)
              {
                wanted[other] = static_cast<std::uint8_t>(level);
                refined.push_back(other);
              }
            else
              for (int k = 0; k < leaves.children; ++k)
                wanted[leaves.family[other] + k] = static_cast<std::uint8_t>(present);
          });
        }
    }
  } // namespace

  template <int dim>
  std::vector<std::uint8_t>
  agree_levels(const Lattice<dim> &lattice, std::span<const CellKey> leaves, std::span<const std::uint8_t> target)
  {
    if (leaves.size() != target.size())
      throw StateError(std::to_string(target.size()) + " target levels for " + std::to_string(leaves.size()) +
                       " leaves");
    std::vector<std::uint8_t> level = wanted_levels<dim>(lattice, leaves, target);
    if (std::equal(level.begin(), level.end(), leaves.begin(),
                   [](std::uint8_t wanted, CellKey key) { return wanted == key_level(key); }))
      return level;
    const Leaves<dim> forest(lattice, leaves);
    cancel_coarsening(forest, level);
    spread_refinement(forest, level);
    return level;
  }

  template <int dim>
  std::vector<CellKey>
  adapted_leaves(const Lattice<dim> &lattice, std::span<const CellKey> leaves, std::span<const std::uint8_t> level)
  {
    std::vector<CellKey> result;
    result.reserve(leaves.size() + leaves.size() / 4);
    for (std::size_t i = 0; i < leaves.size();)
      {
        const int present = key_level(leaves[i]);
        if (level[i] < present)
          {
            result.push_back(ancestor_key(lattice, leaves[i], present - 1));
            i += 1 << dim;
            continue;
          }
        if (level[i] > present)
          for (int child = 0; child < (1 << dim); ++child)
            result.push_back(child_key(lattice, leaves[i], child));
        else
          result.push_back(leaves[i]);
        ++i;
      }
    return result;
  }

  template std::vector<std::uint8_t>
  agree_levels<2>(const Lattice<2> &, std::span<const CellKey>, std::span<const std::uint8_t>);
  template std::vector<CellKey>
  adapted_leaves<2>(const Lattice<2> &, std::span<const CellKey>, std::span<const std::uint8_t>);
} // namespace whipple
