// SPDX-License-Identifier: LGPL-2.1-or-later
#pragma once

#include <whipple/projection/representation.h>

#include <span>

namespace whipple::projection
{
  /// What a piece off the axis is, in axisymmetry: a ring that stands for the many fragments around it.
  enum class Rings
  {
    solid,  ///< its section shrinks as it flies outwards
    thinned ///< its section stays as large as the fragments; void opens between them as they move apart
  };

  /// What forming fragments did; all ranks know all of it.
  struct FragmentReport
  {
    double kinetic_loss = 0; ///< of the motion inside of pieces, and across the axis, Mbar cm^3
    double axis_impulse = 0; ///< radial momentum that the axis took, g cm/us
    long   pieces       = 0; ///< formed
    double mass         = 0; ///< in them, g
    long   not_formed   = 0; ///< groups that would have reached across the axis
  };

  /// Gather elements into solid pieces, one a fragment (doc/theory/fragments.md). Elements whose fragments are too
  /// small to be shown, or that have not broken, stay as they are.
  /// @param elements of all ranks, ordered by key
  /// @param size     of the fragments that each element breaks into, cm; not positive: it has not broken
  /// @returns as many elements, with the same keys; those of a piece have its number
  std::vector<Element<2>>
  form_fragments(const LandingView &view, std::vector<Element<2>> elements, std::span<const double> size, Rings rings,
                 FragmentReport &report);
} // namespace whipple::projection
