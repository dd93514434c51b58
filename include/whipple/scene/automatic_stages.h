// SPDX-License-Identifier: LGPL-2.1-or-later
#pragma once

#include <whipple/scene/prm_statements.h>

#include <vector>

namespace whipple
{
  /// `Stages/List = automatic`: the chain that the bodies ask for (doc/theory/stages.md, "The automatic chain"), as the
  /// statements that one would write by hand. For plates 1 ... n along axis 1, whatever is no plate entering first:
  ///
  ///     perforation k   eulerian     until debris is free of plate k
  ///     debris k        lagrangian   until leading edge reaches plate k + 1
  ///     impact          eulerian     until settled, with the last plate
  ///
  /// How debris lands (Representation, Hand-over, Fragment size, Fragment rings) may be said in the section Stages
  /// itself, for all stages. The statements of the chain stand before the statements of the file, so that any of them
  /// can be overruled there.
  /// @throws InputError if there is no plate, a plate's place cannot be read, or plates overlap.
  void
  expand_automatic_stages(std::vector<PrmStatement> &statements);
} // namespace whipple
