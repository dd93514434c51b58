// SPDX-License-Identifier: LGPL-2.1-or-later
#pragma once

#include <vector>

namespace whipple
{
  /// Choices of the remap.
  struct RemapParameters
  {
    bool second_order = true; ///< limited linear reconstruction; false: donor values
    bool kinetic_loss_to_heat =
        true; ///< kinetic energy lost by the remap heats the material; false: dropped (1993), only booked
    double remnant_fraction = 1e-6; ///< a donor that would keep less than this share of its volume gives all
    double advection_limit  = 0.45; ///< largest displacement of a node in a step, in edges of the cells around it

    /// [material] c^2 where it is cold and free of pressure, cm^2/us^2; 0 for gases. What is not listed is a gas.
    std::vector<double> cold_stiffness{};
  };
} // namespace whipple
