// SPDX-License-Identifier: LGPL-2.1-or-later
#pragma once

#include <array>

namespace whipple
{
  /// What happens at a side of the domain.
  enum class BoundaryKind
  {
    reflecting,   ///< symmetry plane, axis or rigid smooth wall: normal velocity 0
    transmitting, ///< material leaves freely; waves in material that touches the side are absorbed
    inflow        ///< velocity of the side's nodes is prescribed (pistons)
  };

  /// One side of the domain.
  template <int dim>
  struct Boundary
  {
    BoundaryKind            kind = BoundaryKind::transmitting;
    std::array<double, dim> velocity{}; ///< cm/us, for `inflow` only
  };

  /// All sides, ordered 2 * axis + {0 lower, 1 upper}.
  template <int dim>
  using Boundaries = std::array<Boundary<dim>, 2 * dim>;
} // namespace whipple
