// SPDX-License-Identifier: LGPL-2.1-or-later
#include <whipple/error.h>
#include <whipple/material/parameter_check.h>
#include <whipple/material/softened_strength.h>
#include <whipple/material/thermal_blocks.h>

#include <algorithm>

namespace whipple
{
  SoftenedStrength::SoftenedStrength(std::shared_ptr<const Strength> inner, std::shared_ptr<const ThermalModel> thermal,
                                     double reference_temperature)
    : inner_(std::move(inner))
    , thermal_(std::move(thermal))
    , reference_temperature_(reference_temperature)
  {
    if (!inner_)
      throw InputError("thermal softening: needs a strength model");
    if (inner_->softens())
      throw InputError("thermal softening: strength = '" + inner_->name() + "' softens by itself");
    if (!thermal_)
      throw InputError("thermal softening of strength = '" + inner_->name() + "': needs a thermal model");
    require_not_negative("thermal softening", "reference temperature", reference_temperature, "K");
  }

  void
  SoftenedStrength::evaluate(const StrengthInput &state, std::span<double> shear_modulus,
                             std::span<double> yield_stress) const
  {
    inner_->evaluate(state, shear_modulus, yield_stress);
    for_each_thermal_point(*thermal_, state.density, state.energy, [&](std::size_t i, const ThermalPoint &point) {
      const double above = point.temperature - reference_temperature_;
      const double below = point.melt_temperature - point.temperature;
      // (T_m - T)/(T_m - T_ref) without a division by zero, also for a material that never melts: T_m is infinite then.
      const double left  = below > 0. ? 1. / (1. + std::max(above, 0.) / below) : 0.;
      const double solid = 1. - point.melt_fraction;
      shear_modulus[i] *= solid;
      yield_stress[i] *= left * solid;
    });
  }

  bool
  SoftenedStrength::needs_pressure() const
  {
    return inner_->needs_pressure();
  }

  bool
  SoftenedStrength::needs_strain_rate() const
  {
    return inner_->needs_strain_rate();
  }

  bool
  SoftenedStrength::softens() const
  {
    return true;
  }

  double
  SoftenedStrength::reference_shear_modulus() const
  {
    return inner_->reference_shear_modulus();
  }

  std::string
  SoftenedStrength::name() const
  {
    return inner_->name();
  }
} // namespace whipple
