// SPDX-License-Identifier: LGPL-2.1-or-later
#pragma once

#include <whipple/material/lindemann_melting.h>
#include <whipple/material/strength.h>
#include <whipple/material/thermal_model.h>

#include <memory>

namespace whipple
{
  /// Shear modulus and yield stress of metals at high strain rates, with eta = gamma/gamma0:
  ///
  ///   G = G0 [1 + A P / eta^(1/3) - B (T - 300 K)],   Y = min{Y0 [1 + beta (eps_p + eps_i)]^n, Y_max} G / G0,
  ///
  /// both zero at and above the model's own melting temperature T_m0 exp[2a(1 - 1/eta)] eta^(2(Gamma0 - a - 1/3)),
  /// where the bracket is negative, and times the share that the thermal model has not melted. doc/theory/strength.md.
  class SteinbergGuinan : public Strength
  {
  public:
    struct Constants
    {
      double density               = 0; ///< gamma0 [g/cm^3], > 0
      double shear_modulus         = 0; ///< G0 [Mbar], > 0
      double yield_stress          = 0; ///< Y0 [Mbar], >= 0
      double maximum_yield_stress  = 0; ///< Y_max [Mbar], >= Y0
      double hardening_coefficient = 0; ///< beta, >= 0
      double hardening_exponent    = 0; ///< n, >= 0
      double initial_strain        = 0; ///< eps_i, >= 0
      double pressure_coefficient  = 0; ///< A [1/Mbar], >= 0
      double thermal_coefficient   = 0; ///< B [1/K], >= 0
      double melt_temperature      = 0; ///< T_m0 [K], > 0
      double grueneisen            = 0; ///< Gamma0
      double volume_correction     = 0; ///< a
    };

    /// @throws InputError for constants outside their ranges or without a thermal model.
    SteinbergGuinan(const Constants &constants, std::shared_ptr<const ThermalModel> thermal);

    void
    evaluate(const StrengthInput &state, std::span<double> shear_modulus,
             std::span<double> yield_stress) const override;
    bool
    needs_pressure() const override;
    bool
    softens() const override;
    double
    reference_shear_modulus() const override;
    std::string
    name() const override;

  private:
    Constants                           constants_;
    LindemannMelting                    melting_;
    std::shared_ptr<const ThermalModel> thermal_;
  };
} // namespace whipple
