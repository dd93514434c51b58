// SPDX-License-Identifier: LGPL-2.1-or-later
#include <whipple/error.h>
#include <whipple/material/common_constants.h>
#include <whipple/material/johnson_cook.h>
#include <whipple/material/johnson_cook_constants.h>
#include <whipple/material/model_registry.h>
#include <whipple/material/parameter_check.h>
#include <whipple/material/thermal_blocks.h>
#include <whipple/material/thermal_constants.h>

#include <algorithm>
#include <cmath>

namespace whipple
{
  JohnsonCook::JohnsonCook(const Constants &constants, std::shared_ptr<const ThermalModel> thermal)
    : constants_(constants)
    , thermal_(std::move(thermal))
  {
    require_positive(name(), "shear modulus", constants.shear_modulus, "Mbar");
    require_not_negative(name(), "yield stress", constants.yield_stress, "Mbar");
    require_not_negative(name(), "hardening modulus", constants.hardening_modulus, "Mbar");
    require_not_negative(name(), "hardening exponent", constants.hardening_exponent, "");
    require_not_negative(name(), "rate coefficient", constants.rate_coefficient, "");
    require_positive(name(), "reference strain rate", constants.reference_rate, "1/us");
    require_positive(name(), "thermal exponent", constants.thermal_exponent, "");
    require_not_negative(name(), "reference temperature", constants.reference_temperature, "K");
    require_greater(name(), "melt temperature", constants.melt_temperature, constants.reference_temperature, "K");
    if (!thermal_)
      throw InputError("strength = '" + name() + "': needs a thermal model");
  }

  void
  JohnsonCook::evaluate(const StrengthInput &state, std::span<double> shear_modulus,
                        std::span<double> yield_stress) const
  {
    const Constants &c        = constants_;
    const bool       rated    = needs_strain_rate();
    const double     per_rate = 1. / c.reference_rate;
    const double     span     = 1. / (c.melt_temperature - c.reference_temperature);
    for_each_thermal_point(*thermal_, state.density, state.energy, [&](std::size_t i, const ThermalPoint &point) {
      const double solid = 1. - point.melt_fraction;
      const double hardened =
          c.yield_stress + c.hardening_modulus * std::pow(state.plastic_strain[i], c.hardening_exponent);
      const double rate       = rated ? std::max(state.strain_rate[i] * per_rate, 1.) : 1.;
      const double homologous = std::clamp((point.temperature - c.reference_temperature) * span, 0., 1.);
      shear_modulus[i]        = c.shear_modulus * solid;
      yield_stress[i]         = hardened * (1. + c.rate_coefficient * std::log(rate)) *
                        (1. - std::pow(homologous, c.thermal_exponent)) * solid;
    });
  }

  bool
  JohnsonCook::needs_strain_rate() const
  {
    return constants_.rate_coefficient > 0.;
  }

  bool
  JohnsonCook::softens() const
  {
    return true;
  }

  double
  JohnsonCook::reference_shear_modulus() const
  {
    return constants_.shear_modulus;
  }

  std::string
  JohnsonCook::name() const
  {
    return "johnson-cook";
  }

  namespace
  {
    std::vector<PublishedConstants>
    published()
    {
      std::vector<PublishedConstants> result;
      for (const JohnsonCookConstants &c : johnson_cook_table())
        result.push_back({c.material,
                          {{"Yield stress", c.yield_stress},
                           {"Johnson-Cook hardening modulus", c.hardening_modulus},
                           {"Johnson-Cook hardening exponent", c.hardening_exponent},
                           {"Johnson-Cook rate coefficient", c.rate_coefficient},
                           {"Johnson-Cook thermal exponent", c.thermal_exponent},
                           {"Johnson-Cook melt temperature", c.melt_temperature}},
                          c.source,
                          c.caution});
      return result;
    }

    ModelDescription
    description()
    {
      using namespace common_constants;
      return {.name          = "johnson-cook",
              .summary       = "yield stress that hardens with strain and strain rate and softens with temperature",
              .documentation = "Y = (A + B eps_p^n)(1 + C ln(rate/rate0))(1 - T*^m), A the yield stress, T* = (T - "
                               "T_ref)/(T_m - T_ref); "
                               "rates below rate0 and temperatures below T_ref have no influence; Y and G are zero in "
                               "the melt. Fitted to "
                               "tests up to about 1e4/s: at the 1e6/s of hypervelocity impact the logarithm is an "
                               "extrapolation, and the "
                               "pressure does not stiffen the material. Needs a thermal model.",
              .constants     = {shear_modulus,
                                yield_stress,
                                {"Johnson-Cook hardening modulus", "pressure", "B", Range::not_negative(), {}, false},
                                {"Johnson-Cook hardening exponent", "pure number", "n", Range::not_negative(), {}, false},
                                {"Johnson-Cook rate coefficient", "pure number", "C", Range::not_negative(), {}, false},
                                {"Johnson-Cook thermal exponent", "pure number", "m", Range::positive(), {}, false},
                                johnson_cook_melt_temperature,
                                reference_strain_rate,
                                reference_temperature},
              .source        = "G. R. Johnson and W. H. Cook, 7th Int. Symp. on Ballistics (1983) 541-547",
              .published     = published()};
    }

    const Registration<Strength> registration(description(), [](const ModelInput &c) {
      return std::make_shared<JohnsonCook>(
          JohnsonCook::Constants{c("Shear modulus"), c("Yield stress"), c("Johnson-Cook hardening modulus"),
                                 c("Johnson-Cook hardening exponent"), c("Johnson-Cook rate coefficient"),
                                 c("Reference strain rate"), c("Johnson-Cook thermal exponent"),
                                 c("Johnson-Cook melt temperature"), c("Reference temperature")},
          c.thermal);
    });
  } // namespace
} // namespace whipple
