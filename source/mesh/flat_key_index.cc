// SPDX-License-Identifier: LGPL-2.1-or-later
#include <whipple/error.h>
#include <whipple/mesh/key_index.h>

#include <bit>
#include <string>

namespace whipple
{
  KeyIndex::KeyIndex(std::size_t expected)
  {
    allocate(expected);
  }

  KeyIndex::KeyIndex(std::span<const CellKey> keys)
  {
    allocate(keys.size());
    for (std::size_t i = 0; i < keys.size(); ++i)
      if (insert(keys[i], static_cast<Index>(i)) != static_cast<Index>(i))
        throw StateError("cell key " + std::to_string(keys[i]) + " appears twice among " + std::to_string(keys.size()) +
                         " cells");
  }

  void
  KeyIndex::allocate(std::size_t expected)
  {
    const std::size_t slots = std::bit_ceil(2 * expected + 16);
    slot_.assign(slots, Slot{vacant, none});
    mask_  = slots - 1;
    shift_ = 64 - std::countr_zero(slots);
    size_  = 0;
  }

  Index
  KeyIndex::insert(CellKey key, Index value)
  {
    if (2 * (size_ + 1) > slot_.size())
      {
        std::vector<Slot> old = std::move(slot_);
        allocate(old.size());
        for (const Slot &slot : old)
          if (slot.key != vacant)
            insert(slot.key, slot.value);
      }
    std::size_t slot = home(key);
    while (slot_[slot].key != vacant)
      {
        if (slot_[slot].key == key)
          return slot_[slot].value;
        slot = (slot + 1) & mask_;
      }
    slot_[slot] = {key, value};
    ++size_;
    return value;
  }
} // namespace whipple
