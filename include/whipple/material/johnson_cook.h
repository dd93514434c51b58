// SPDX-License-Identifier: LGPL-2.1-or-later
#pragma once

#include <whipple/material/strength.h>
#include <whipple/material/thermal_model.h>

#include <memory>

namespace whipple
{
  /// Y = (A + B eps_p^n) (1 + C ln max(rate/rate0, 1)) (1 - T*^m) (1 - m_l), constant G (1 - m_l), with the melt
  /// fraction m_l of the thermal model and T* = (T - T_ref)/(T_m - T_ref) limited to 0 ... 1. doc/theory/strength.md.
  class JohnsonCook : public Strength
  {
  public:
    struct Constants
    {
      double shear_modulus         = 0;    ///< G [Mbar], > 0
      double yield_stress          = 0;    ///< A [Mbar], >= 0
      double hardening_modulus     = 0;    ///< B [Mbar], >= 0
      double hardening_exponent    = 0;    ///< n, >= 0
      double rate_coefficient      = 0;    ///< C, >= 0; 0: the strain rate is not asked for
      double reference_rate        = 1e-6; ///< rate0 [1/us], > 0
      double thermal_exponent      = 1;    ///< m, > 0
      double melt_temperature      = 0;    ///< T_m of T* [K], > T_ref
      double reference_temperature = 300.; ///< T_ref [K], >= 0
    };

    /// @throws InputError for constants outside their ranges or without a thermal model.
    JohnsonCook(const Constants &constants, std::shared_ptr<const ThermalModel> thermal);

    void
    evaluate(const StrengthInput &state, std::span<double> shear_modulus,
             std::span<double> yield_stress) const override;
    bool
    needs_strain_rate() const override;
    bool
    softens() const override;
    double
    reference_shear_modulus() const override;
    std::string
    name() const override;

  private:
    Constants                           constants_;
    std::shared_ptr<const ThermalModel> thermal_;
  };
} // namespace whipple
