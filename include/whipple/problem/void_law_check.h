// SPDX-License-Identifier: LGPL-2.1-or-later
#pragma once

#include <whipple/problem/problem.h>
#include <whipple/scene/section.h>

namespace whipple::sections
{
  /// Cells become elements where a Lagrangian stage follows an Eulerian one, and elements have no open void: the
  /// materials take it up, for which they need a void law. Cells can do without where they are all full: bodies that
  /// fill the domain, bodies at rest whose faces lie on mesh lines, or a void cutoff of 0.
  /// Needs bodies, stages, effects and lattice.
  /// @throws InputError
  template <int dim>
  void
  check_void_laws(SceneParameters &parameters, const Problem<dim> &problem);
} // namespace whipple::sections
