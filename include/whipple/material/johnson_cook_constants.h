// SPDX-License-Identifier: LGPL-2.1-or-later
#pragma once

#include <whipple/material/model_description.h>

#include <array>
#include <optional>

namespace whipple
{
  /// Constants of the flow stress [Johnson1983] and failure strain [Johnson1985] for one material.
  struct JohnsonCookConstants
  {
    std::string material;
    double      yield_stress;       ///< A [Mbar]
    double      hardening_modulus;  ///< B [Mbar]
    double      hardening_exponent; ///< n
    double      rate_coefficient;   ///< C
    double      thermal_exponent;   ///< m
    double      melt_temperature;   ///< of T* [K]

    std::optional<std::array<double, 5>> damage; ///< D1 ... D5; empty: not published here

    std::string source;
    std::string caution; ///< what to know before trusting them; empty if nothing
  };

  /// All of them, alphabetically.
  const std::vector<JohnsonCookConstants> &
  johnson_cook_table();
} // namespace whipple

namespace whipple::common_constants
{
  inline const ModelConstant johnson_cook_melt_temperature{
      "Johnson-Cook melt temperature", "temperature", "at which T* is 1", Range::positive(), {}, false};
  inline const ModelConstant reference_strain_rate{
      "Reference strain rate", "rate", "below which the rate has no influence", Range::positive(), 1e-6, false};
} // namespace whipple::common_constants
