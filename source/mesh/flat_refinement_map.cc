// SPDX-License-Identifier: LGPL-2.1-or-later
#include <whipple/error.h>
#include <whipple/mesh/gather.h>
#include <whipple/mesh/key_arithmetic.h>
#include <whipple/mesh/refinement_map.h>

#include <algorithm>
#include <cmath>
#include <string>

namespace whipple
{
  template <int dim>
  RefinementMap<dim>::RefinementMap(const Lattice<dim> &lattice)
    : lattice_(lattice)
    , covered_(lattice.max_level + 1)
  {
    require_packable(lattice);
  }

  template <int dim>
  void
  RefinementMap<dim>::request(int level, LatticePoint<dim> lower, LatticePoint<dim> upper, int buffer)
  {
    if (level < 0 || level > lattice_.max_level || buffer < 0)
      throw StateError("refinement request for level " + std::to_string(level) + " with a buffer of " +
                       std::to_string(buffer) + " cells; levels go from 0 to " + std::to_string(lattice_.max_level));
    const int block  = lattice_.extent(block_level(level));
    const int margin = buffer * lattice_.extent(level);
    for (int d = 0; d < dim; ++d)
      {
        if (upper[d] <= lower[d])
          throw StateError("refinement request for an empty box: [" + std::to_string(lower[d]) + ", " +
                           std::to_string(upper[d]) + ") along axis " + std::to_string(d));
        lower[d] = std::max(lower[d] - margin, 0) / block;
        upper[d] = (std::min(upper[d] + margin, lattice_.finest(d)) + block - 1) / block;
      }

    LatticePoint<dim> at = lower;
    for (int d = 0; d < dim; ++d)
      if (lower[d] >= upper[d])
        return; // outside the domain
    for (int axis = 0; axis < dim;)
      {
        LatticePoint<dim> corner;
        for (int d = 0; d < dim; ++d)
          corner[d] = at[d] * block;
        remember(make_key<dim>(level, corner));
        for (axis = 0; axis < dim && ++at[axis] == upper[axis]; ++axis)
          at[axis] = lower[axis];
      }
  }

  template <int dim>
  void
  RefinementMap<dim>::request(int level, const Vector<dim> &lower, const Vector<dim> &upper, int buffer)
  {
    LatticePoint<dim> from, to;
    for (int d = 0; d < dim; ++d)
      {
        if (!(lower[d] <= upper[d]))
          throw StateError("refinement request for the box [" + std::to_string(lower[d]) + ", " +
                           std::to_string(upper[d]) + "] cm along axis " + std::to_string(d));
        // what is out of the buffer's reach stays so when cut back; the integers below cannot overflow
        const double reach = lattice_.finest(d) + 1. + static_cast<double>(buffer) * lattice_.extent(0);
        const double first = std::clamp((lower[d] - lattice_.origin[d]) / lattice_.spacing, -reach, reach);
        const double last  = std::clamp((upper[d] - lattice_.origin[d]) / lattice_.spacing, -reach, reach);
        from[d]            = static_cast<int>(std::floor(first));
        to[d]              = std::max(static_cast<int>(std::ceil(last)), from[d] + 1);
      }
    request(level, from, to, buffer);
  }

  template <int dim>
  void
  RefinementMap<dim>::remember(CellKey block)
  {
    const Index next = static_cast<Index>(requested_.size());
    if (known_.insert(block, next) == next)
      requested_.push_back(block);
  }

  template <int dim>
  void
  RefinementMap<dim>::synchronise(MPI_Comm communicator)
  {
    const Gathered<CellKey> all = gather_all<CellKey>(communicator, requested_);
    for (const CellKey key : all.entry)
      remember(key);

    for (KeyIndex &covered : covered_)
      covered = KeyIndex();
    for (const CellKey key : requested_)
      {
        const int level = key_level(key);
        // an ancestor that is there already has brought its own ancestors
        for (int q = block_level(level); q >= 0; --q)
          {
            const CellKey ancestor = ancestor_key(lattice_, key, q);
            if (covered_[level].contains(ancestor))
              break;
            covered_[level].insert(ancestor, 0);
          }
      }
  }

  template <int dim>
  void
  RefinementMap<dim>::clear()
  {
    requested_.clear();
    known_ = KeyIndex();
    for (KeyIndex &covered : covered_)
      covered = KeyIndex();
  }

  template <int dim>
  bool
  RefinementMap<dim>::overlaps(int level, CellKey leaf) const
  {
    return covered_[level].size() > 0 &&
           covered_[level].contains(ancestor_key(lattice_, leaf, std::min(key_level(leaf), block_level(level))));
  }

  template <int dim>
  std::uint8_t
  RefinementMap<dim>::target_level(CellKey leaf) const
  {
    for (int level = lattice_.max_level; level > 0; --level)
      if (overlaps(level, leaf))
        return static_cast<std::uint8_t>(level);
    return 0;
  }

  template <int dim>
  bool
  RefinementMap<dim>::touched(CellKey leaf) const
  {
    for (int level = lattice_.max_level; level >= 0; --level)
      if (overlaps(level, leaf))
        return true;
    return false;
  }

  template class RefinementMap<2>;
} // namespace whipple
