// SPDX-License-Identifier: LGPL-2.1-or-later
#pragma once

#include <whipple/mesh/flat_mesh.h>

#include <cstddef>
#include <span>
#include <vector>

namespace whipple
{
  /// Hash table from cell keys to indices (linear probing, at most half full); std::unordered_map costs several
  /// times as much. It can be used as a set too. It cannot be iterated, so nothing can depend on its internal order.
  class KeyIndex
  {
  public:
    /// An empty table with room for that many keys before it grows.
    explicit KeyIndex(std::size_t expected = 0);

    /// Maps keys[i] to i.
    /// @throws StateError if a key appears twice.
    explicit KeyIndex(std::span<const CellKey> keys);

    /// The index stored for a key; stores `value` first if the key is new.
    Index
    insert(CellKey key, Index value);

    /// The key's index, or `none`.
    Index
    find(CellKey key) const
    {
      for (std::size_t slot = home(key);; slot = (slot + 1) & mask_)
        {
          if (slot_[slot].key == key)
            return slot_[slot].value;
          if (slot_[slot].key == vacant)
            return none;
        }
    }

    bool
    contains(CellKey key) const
    {
      return find(key) != none;
    }

    std::size_t
    size() const
    {
      return size_;
    }

  private:
    struct Slot
    {
      CellKey key;
      Index   value;
    };

    /// No cell has this key: its level would be 127.
    static constexpr CellKey vacant = ~CellKey{0};

    std::size_t
    home(CellKey key) const
    {
      // coordinates of coarse cells end in zeros: fold the upper half down, then multiplicative hashing
      return static_cast<std::size_t>(((key ^ (key >> 32)) * 0x9e3779b97f4a7c15u) >> shift_);
    }

    void
    allocate(std::size_t expected);

    std::vector<Slot> slot_;
    std::size_t       mask_  = 0;
    std::size_t       size_  = 0;
    int               shift_ = 0;
  };
} // namespace whipple
