// SPDX-License-Identifier: LGPL-2.1-or-later
#pragma once

#include <whipple/problem/problem.h>
#include <whipple/scene/section.h>

namespace whipple::sections
{
  /// On a fixed mesh what enters through an `inflow` side has the state of the cell that it enters
  /// (doc/theory/remap.md). Waves from inside keep that state right as long as they reach the side: not if the flow
  /// there is faster than sound. Refused is a scene in which the wave that the side drives into a body that touches it
  /// leaves such a flow behind. Needs bodies, stages and materials.
  /// @throws InputError
  template <int dim>
  void
  check_inflow(SceneParameters &parameters, const Problem<dim> &problem);
} // namespace whipple::sections
