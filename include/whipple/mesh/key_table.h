// SPDX-License-Identifier: LGPL-2.1-or-later
#pragma once

#include <whipple/mesh/index.h>

#include <bit>
#include <cstdint>
#include <vector>

namespace whipple
{
  /// Map from 64-bit integer keys to Index by open addressing; built once for a known number of keys, then
  /// only asked. A regrid asks it a dozen times a cell, where std::unordered_map costs five times as much.
  class KeyTable
  {
  public:
    explicit KeyTable(std::size_t n_keys)
      : mask_(std::bit_ceil(2 * n_keys + 2) - 1)
      , key_(mask_ + 1, empty)
      , value_(mask_ + 1, none)
    {
    }

    /// The value stored for a key; stores `value` first if the key is new.
    Index
    insert(std::uint64_t key, Index value)
    {
      std::size_t slot = find_slot(key);
      if (key_[slot] == empty)
        {
          key_[slot]   = key;
          value_[slot] = value;
        }
      return value_[slot];
    }

    /// The value of a key, `none` if absent.
    Index
    find(std::uint64_t key) const
    {
      return value_[find_slot(key)];
    }

  private:
    static constexpr std::uint64_t empty = ~std::uint64_t{0};

    std::size_t
    find_slot(std::uint64_t key) const
    {
      // Fibonacci hashing; the high bits are the well mixed ones
      std::size_t slot = ((key * 0x9e3779b97f4a7c15u) >> 20) & mask_;
      while (key_[slot] != empty && key_[slot] != key)
        slot = (slot + 1) & mask_;
      return slot;
    }

    std::size_t                mask_;
    std::vector<std::uint64_t> key_;
    std::vector<Index>         value_;
  };
} // namespace whipple
