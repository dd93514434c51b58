// SPDX-License-Identifier: LGPL-2.1-or-later
#pragma once

#include <whipple/exact/exact_factory.h>

namespace whipple::exact
{
  /// A piston driven with constant speed into a uniform fluid at rest or in motion, without strength: the half of the
  /// Riemann problem of the fluid and its mirror image in the frame of the piston, whose contact is the piston
  /// (Saltzman's problem; doc/theory/exact_gas.md).
  ExactKind
  gas_piston_kind();

  /// From the one body of the scene and the velocity of the side Bottom, `inflow`, that it touches.
  std::unique_ptr<const ExactSolution<2>>
  make_gas_piston(const ExactRequest<2> &request);
} // namespace whipple::exact
