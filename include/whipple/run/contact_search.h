// SPDX-License-Identifier: LGPL-2.1-or-later
#pragma once

#include <whipple/mesh/cell_geometry.h>
#include <whipple/mesh/flat_mesh.h>
#include <whipple/mesh/index.h>

#include <mpi.h>

#include <cstdint>
#include <span>
#include <vector>

/// Search for elements that lie in one another, by bins.
namespace whipple::contact
{
  /// An element as the search sees it; travels between ranks as it is.
  struct Piece
  {
    CellKey          key = 0;
    CornerVectors<2> x{};          ///< corners, cm
    Vector<2>        middle{};     ///< mean of the corners, cm
    double           size  = 0;    ///< square root of its area, cm
    double           solid = 0;    ///< sum of (1 - phi) V_m over the volume of the element
    double           mass  = 0;    ///< g
    Vector<2>        velocity{};   ///< of its centre of mass, cm/us
    double           relative = 0; ///< kinetic energy about it, Mbar cm^3
    std::uint64_t    held     = 0; ///< bit d: may not move along axis d
  };

  /// Two elements that lie in one another.
  struct Pair
  {
    Piece        a, b;
    std::int64_t approaching = 0; ///< they come closer (else they keep their distance)
  };

  struct Found
  {
    std::vector<Pair> pairs;            ///< whose middles this rank looked after; opening contacts left out
    long              deep         = 0; ///< pieces of this rank's bins that lie deep in others
    double            time_to_next = 0; ///< us; of this rank's bins
  };

  /// Solid around a point, as a part of what fits, above which elements are in contact.
  inline constexpr double contact_solid = 1.05;

  /// Collective. Which pairs are found does not depend on the ranks, nor on the size of the bins.
  /// @param mine  this rank's pieces
  Found
  search(MPI_Comm communicator, std::span<const Piece> mine);

  /// Whether a point lies in a quadrilateral (lexicographic corners), folded ones by the parity of crossings.
  bool
  is_inside(const CornerVectors<2> &x, const Vector<2> &point);
} // namespace whipple::contact
