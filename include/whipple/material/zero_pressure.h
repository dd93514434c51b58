// SPDX-License-Identifier: LGPL-2.1-or-later
#pragma once

#include <whipple/material/equation_of_state.h>

#include <optional>

namespace whipple
{
  /// gamma0 / gamma >= 1 of the densest state with that energy [Mbar cm^3/g] and no pressure, searched up to `upper`;
  /// empty if there is none.
  std::optional<double>
  zero_pressure_volume(const EquationOfState &eos, double energy, double upper);
} // namespace whipple
