// SPDX-License-Identifier: LGPL-2.1-or-later
#pragma once

#include <cstddef>
#include <cstdint>
#include <vector>

namespace whipple
{
  /// How cells hold together.
  enum class Cohesion
  {
    bonded,   ///< every shared face joins its cells: corners that meet are one node
    graded,   ///< a shared face joins its cells where the material on both sides is intact
    fragments ///< no face joins: every cell has its own nodes
  };

  /// Which cells (or leaves, in the order of the list they go with) are intact: a face joins two cells that both are.
  class Bonds
  {
  public:
    /// All cells alike: `bonded` or `fragments`.
    /// @throws StateError for `graded`, which has to be said cell by cell.
    Bonds(Cohesion cohesion); // NOLINT: a uniform cohesion is a set of bonds

    /// @param intact nonzero for intact cells, one entry each
    explicit Bonds(std::vector<std::uint8_t> intact);

    bool
    intact(std::size_t cell) const
    {
      return uniform_ ? all_ : intact_[cell] != 0;
    }

    /// @throws StateError unless the bonds are uniform or given for that many cells.
    void
    require_size(std::size_t cells) const;

  private:
    bool                      uniform_ = false;
    bool                      all_     = false;
    std::vector<std::uint8_t> intact_; ///< empty where uniform
  };
} // namespace whipple
