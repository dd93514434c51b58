// SPDX-License-Identifier: LGPL-2.1-or-later
#pragma once

#include <whipple/material/strength.h>
#include <whipple/material/thermal_model.h>

#include <memory>

namespace whipple
{
  /// A strength model that knows no temperature, softened by that of a thermal model: with T* = (T - T_ref)/(T_m -
  /// T_ref) limited to 0 ... 1, T_m that of the thermal model at this density, and the melt fraction m_l,
  ///
  ///   Y = Y_inner (1 - T*) (1 - m_l),   G = G_inner (1 - m_l).
  ///
  /// Y is continuous and zero from the onset of melting on, G from its end on. doc/theory/strength.md.
  class SoftenedStrength : public Strength
  {
  public:
    /// @param reference_temperature  T_ref [K], below which nothing softens
    /// @throws InputError without an inner model, if it softens already, without a thermal model, or for T_ref < 0.
    SoftenedStrength(std::shared_ptr<const Strength> inner, std::shared_ptr<const ThermalModel> thermal,
                     double reference_temperature = 300.);

    void
    evaluate(const StrengthInput &state, std::span<double> shear_modulus,
             std::span<double> yield_stress) const override;
    bool
    needs_pressure() const override;
    bool
    needs_strain_rate() const override;
    bool
    softens() const override;
    double
    reference_shear_modulus() const override;

    /// That of the inner model.
    std::string
    name() const override;

  private:
    std::shared_ptr<const Strength>     inner_;
    std::shared_ptr<const ThermalModel> thermal_;
    double                              reference_temperature_;
  };
} // namespace whipple
