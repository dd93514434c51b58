// SPDX-License-Identifier: LGPL-2.1-or-later
#pragma once

#include <whipple/mesh/flat_builder.h>
#include <whipple/mesh/key_index.h>

#include <mpi.h>

#include <cstdint>
#include <vector>

namespace whipple
{
  /// Where the mesh shall be how fine. Collects requests "level L in this box and `buffer` cells around it" as
  /// blocks: cells of level max(L - 2, 0), that is 4 x 4 cells of level L. A block is asked for or not, so a front
  /// that moves by less than a block changes nothing: hysteresis without memory.
  ///
  /// Use: request...(), then synchronise(), then ask. What the questions answer depends on the set of
  /// requests of all ranks, not on their order or place.
  template <int dim>
  class RefinementMap
  {
  public:
    /// @throws InputError if the lattice's coordinates do not fit into cell keys.
    explicit RefinementMap(const Lattice<dim> &lattice);

    /// Ask for a level in a box of lattice coordinates [lower, upper), in finest cells, widened on all sides by
    /// `buffer` cells of that level. What lies outside the domain is ignored.
    /// @throws StateError if the level is not in [0, max_level], the buffer is negative or the box is empty.
    void
    request(int level, LatticePoint<dim> lower, LatticePoint<dim> upper, int buffer);

    /// The same for a box in cm, widened outwards to whole finest cells (by one more where a bound on a cell edge is
    /// rounded to the other side; cells know their lattice coordinates and should use those).
    /// @throws StateError also if a bound is not a number or upper < lower.
    void
    request(int level, const Vector<dim> &lower, const Vector<dim> &upper, int buffer);

    /// Unite the requests of all ranks; the answers below follow from here on. Collective.
    void
    synchronise(MPI_Comm communicator);

    /// Forget all requests and answers.
    void
    clear();

    /// Highest level whose blocks overlap the leaf, 0 if none does.
    std::uint8_t
    target_level(CellKey leaf) const;

    /// Whether any block overlaps the leaf.
    bool
    touched(CellKey leaf) const;

    /// Number of blocks requested so far (before synchronise: by this rank).
    std::size_t
    n_blocks() const
    {
      return requested_.size();
    }

  private:
    static int
    block_level(int level)
    {
      return level > 2 ? level - 2 : 0;
    }

    /// Add a block unless it is there already.
    void
    remember(CellKey block);

    bool
    overlaps(int level, CellKey leaf) const;

    Lattice<dim> lattice_;

    /// Blocks asked for, each as a cell key that holds the requested level and the lower corner of the block.
    std::vector<CellKey> requested_;
    KeyIndex             known_;

    /// [requested level] keys of the blocks and of all cells that contain one.
    std::vector<KeyIndex> covered_;
  };
} // namespace whipple
