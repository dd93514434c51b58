// SPDX-License-Identifier: LGPL-2.1-or-later
#include <whipple/error.h>
#include <whipple/mesh/bonds.h>

#include <string>
#include <utility>

namespace whipple
{
  Bonds::Bonds(Cohesion cohesion)
    : uniform_(true)
    , all_(cohesion == Cohesion::bonded)
  {
    if (cohesion == Cohesion::graded)
      throw StateError("graded cohesion has to say of every cell whether it is intact");
  }

  Bonds::Bonds(std::vector<std::uint8_t> intact)
    : intact_(std::move(intact))
  {
  }

  void
  Bonds::require_size(std::size_t cells) const
  {
    if (!uniform_ && intact_.size() != cells)
      throw StateError(std::to_string(intact_.size()) + " flags of intact cells for " + std::to_string(cells) +
                       " cells");
  }
} // namespace whipple
