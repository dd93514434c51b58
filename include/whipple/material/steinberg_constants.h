// SPDX-License-Identifier: LGPL-2.1-or-later
#pragma once

#include <string>
#include <vector>

namespace whipple
{
  /// What Steinberg gives for a material beyond the constants of the library.
  struct SteinbergConstants
  {
    std::string material;              ///< the library's name
    double      maximum_yield_stress;  ///< Y_max [Mbar]
    double      hardening_coefficient; ///< beta
    double      hardening_exponent;    ///< n
    double      pressure_coefficient;  ///< A = (1/G0) dG/dP [1/Mbar]
    double      thermal_coefficient;   ///< B = -(1/G0) dG/dT [1/K]
    double      volume_correction;     ///< a of the melting law
    std::string caution;               ///< what to know before trusting them; empty if nothing
  };

  /// All of them, alphabetically.
  const std::vector<SteinbergConstants> &
  steinberg_table();

  /// Those of one material.
  /// @throws InputError if there are none.
  const SteinbergConstants &
  steinberg_constants(const std::string &material);
} // namespace whipple
