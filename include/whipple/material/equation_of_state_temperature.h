// SPDX-License-Identifier: LGPL-2.1-or-later
#pragma once

#include <whipple/material/equation_of_state.h>
#include <whipple/material/thermal_model.h>

#include <memory>

namespace whipple
{
  /// The thermal side of an equation of state that knows its own temperature: the same object.
  /// @throws InputError naming the laws that do, if this one does not.
  std::shared_ptr<const ThermalModel>
  equation_of_state_temperature(const std::shared_ptr<const EquationOfState> &eos);
} // namespace whipple
