// SPDX-License-Identifier: LGPL-2.1-or-later
#pragma once

#include <whipple/exact/exact_factory.h>

namespace whipple::exact
{
  /// A piston driven with constant speed into porous material that crushes by the P-alpha law: an elastic precursor and
  /// a compaction shock (CompactionLoading); doc/theory/exact_solid.md.
  ExactKind
  porous_piston_kind();

  /// Piston: the lower or upper side of axis 1, `inflow`; material and state: the one body, which touches that side,
  /// has the void law "p-alpha" and no strength.
  std::unique_ptr<const ExactSolution<2>>
  make_porous_piston(const ExactRequest<2> &request);
} // namespace whipple::exact
