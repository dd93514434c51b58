// SPDX-License-Identifier: LGPL-2.1-or-later
#pragma once

#include <whipple/mesh/halo.h>
#include <whipple/projection/laid.h>

#include <array>

namespace whipple::projection
{
  /// Volume of solid, sum of (1 - phi) V, in a cell, cm^3.
  double
  solid_volume(const std::vector<MaterialState> &materials, Index cell);

  /// Face neighbours of a cell across its subfaces, entry 2 * side + half; `none` where there is none.
  std::array<Index, 8>
  face_neighbours(const FlatMesh<2> &mesh, Index cell);

  /// Moves shares of what was laid down from cell to cell: all givers first keep less, then the others take, out of
  /// what was there at the begin of the round. Mass, momentum, internal and kinetic energy of a share go along.
  class LaidTransfer
  {
  public:
    LaidTransfer(const FlatMesh<2> &mesh, const Halo<2> &halo, Laid &laid);

    /// A new round.
    void
    begin()
    {
      before_ = laid_;
    }

    /// What there was at its begin.
    const Laid &
    before() const
    {
      return before_;
    }

    /// Leave a cell this part of what it holds.
    void
    keep(Index cell, double rest);

    /// Add a share of what `giver` held at the begin of the round: it lies anywhere in the cell, with one velocity.
    void
    take(Index giver, double share, Index cell);

    /// Bring the halo up to date.
    void
    exchange();

  private:
    const FlatMesh<2> &mesh_;
    const Halo<2>     &halo_;
    Laid              &laid_;
    Laid               before_;
  };
} // namespace whipple::projection
