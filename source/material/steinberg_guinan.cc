// SPDX-License-Identifier: LGPL-2.1-or-later
#include <whipple/error.h>
#include <whipple/material/common_constants.h>
#include <whipple/material/model_registry.h>
#include <whipple/material/parameter_check.h>
#include <whipple/material/steinberg_constants.h>
#include <whipple/material/steinberg_guinan.h>
#include <whipple/material/thermal_blocks.h>
#include <whipple/material/thermal_constants.h>

#include <algorithm>
#include <cmath>

namespace whipple
{
  namespace
  {
    constexpr double room_temperature = 300.; // K: of the published G0, part of the model
  }

  SteinbergGuinan::SteinbergGuinan(const Constants &constants, std::shared_ptr<const ThermalModel> thermal)
    : constants_(constants)
    , melting_{constants.grueneisen, constants.volume_correction}
    , thermal_(std::move(thermal))
  {
    require_positive(name(), "density", constants.density, "g/cm^3");
    require_positive(name(), "shear modulus", constants.shear_modulus, "Mbar");
    require_not_negative(name(), "yield stress", constants.yield_stress, "Mbar");
    if (!(constants.maximum_yield_stress >= constants.yield_stress))
      throw InputError(name() + ": maximum yield stress = " + std::to_string(constants.maximum_yield_stress) +
                       " Mbar: must be >= yield stress = " + std::to_string(constants.yield_stress) + " Mbar");
    require_not_negative(name(), "hardening coefficient", constants.hardening_coefficient, "");
    require_not_negative(name(), "hardening exponent", constants.hardening_exponent, "");
    require_not_negative(name(), "initial plastic strain", constants.initial_strain, "");
    require_not_negative(name(), "pressure coefficient", constants.pressure_coefficient, "1/Mbar");
    require_not_negative(name(), "thermal coefficient", constants.thermal_coefficient, "1/K");
    require_positive(name(), "melt temperature", constants.melt_temperature, "K");
    if (!thermal_)
      throw InputError("strength = '" + name() + "': needs a thermal model");
  }

  void
  SteinbergGuinan::evaluate(const StrengthInput &state, std::span<double> shear_modulus,
                            std::span<double> yield_stress) const
  {
    const Constants &c = constants_;
    for_each_thermal_point(*thermal_, state.density, state.energy, [&](std::size_t i, const ThermalPoint &point) {
      const double v         = c.density / state.density[i];
      const double stiffened = 1. + c.pressure_coefficient * state.pressure[i] * std::cbrt(v) -
                               c.thermal_coefficient * (point.temperature - room_temperature);
      const bool   solid    = point.temperature < c.melt_temperature * melting_(v);
      const double scale    = solid ? std::max(stiffened, 0.) * (1. - point.melt_fraction) : 0.;
      const double strain   = state.plastic_strain[i] + c.initial_strain;
      const double hardened = c.yield_stress * std::pow(1. + c.hardening_coefficient * strain, c.hardening_exponent);
      shear_modulus[i]      = c.shear_modulus * scale;
      yield_stress[i]       = std::min(hardened, c.maximum_yield_stress) * scale;
    });
  }

  bool
  SteinbergGuinan::needs_pressure() const
  {
    return true;
  }

  bool
  SteinbergGuinan::softens() const
  {
    return true;
  }

  double
  SteinbergGuinan::reference_shear_modulus() const
  {
    return constants_.shear_modulus;
  }

  std::string
  SteinbergGuinan::name() const
  {
    return "steinberg-guinan";
  }

  namespace
  {
    std::vector<PublishedConstants>
    published()
    {
      std::vector<PublishedConstants> result;
      for (const SteinbergConstants &c : steinberg_table())
        result.push_back({c.material,
                          {{"Maximum yield stress", c.maximum_yield_stress},
                           {"Steinberg hardening coefficient", c.hardening_coefficient},
                           {"Steinberg hardening exponent", c.hardening_exponent},
                           {"Shear modulus pressure coefficient", c.pressure_coefficient},
                           {"Shear modulus thermal coefficient", c.thermal_coefficient},
                           {"Grueneisen volume correction", c.volume_correction}},
                          "Steinberg, UCRL-MA-106439, as typed in the Uintah material files",
                          c.caution});
      return result;
    }

    ModelDescription
    description()
    {
      using namespace common_constants;
      return {
          .name    = "steinberg-guinan",
          .summary = "shear modulus and yield stress of shocked metals: stiffer with pressure, softer with temperature",
          .documentation =
              "G = G0 [1 + A P/eta^(1/3) - B (T - 300 K)] and Y = min{Y0 [1 + beta (eps_p + eps_i)]^n, Y_max} G/G0, "
              "both "
              "zero at and above the melting temperature. Made for strain rates above 1e5/s, where the rate has "
              "saturated: "
              "too strong for slow deformation. The melt temperature is Steinberg's fit at normal density (1220 K for "
              "aluminium), not the melting point; what the thermal model has melted has no strength either. Needs a "
              "thermal model.",
          .constants =
              {density,
               shear_modulus,
               yield_stress,
               {"Maximum yield stress", "pressure", "Y_max, to which Y0 hardens", Range::not_negative(), {}, false},
               {"Steinberg hardening coefficient", "pure number", "beta", Range::not_negative(), {}, false},
               {"Steinberg hardening exponent", "pure number", "n", Range::not_negative(), {}, false},
               {"Initial plastic strain", "pure number", "eps_i, of cold work", Range::not_negative(), 0., false},
               {"Shear modulus pressure coefficient",
                "inverse pressure",
                "A = (1/G0) dG/dP",
                Range::not_negative(),
                {},
                false},
               {"Shear modulus thermal coefficient",
                "inverse temperature",
                "B = -(1/G0) dG/dT",
                Range::not_negative(),
                {},
                false},
               {"Melt temperature",
                "temperature",
                "T_m0 of the model's melting law at gamma0",
                Range::positive(),
                {},
                false},
               grueneisen,
               volume_correction},
          .source    = "D. J. Steinberg, S. G. Cochran and M. W. Guinan, J. Appl. Phys. 51 (1980) 1498-1504",
          .published = published()};
    }

    const Registration<Strength> registration(description(), [](const ModelInput &c) {
      SteinbergGuinan::Constants constants;
      constants.density               = c("Density");
      constants.shear_modulus         = c("Shear modulus");
      constants.yield_stress          = c("Yield stress");
      constants.maximum_yield_stress  = c("Maximum yield stress");
      constants.hardening_coefficient = c("Steinberg hardening coefficient");
      constants.hardening_exponent    = c("Steinberg hardening exponent");
      constants.initial_strain        = c("Initial plastic strain");
      constants.pressure_coefficient  = c("Shear modulus pressure coefficient");
      constants.thermal_coefficient   = c("Shear modulus thermal coefficient");
      constants.melt_temperature      = c("Melt temperature");
      constants.grueneisen            = c("Grueneisen coefficient");
      constants.volume_correction     = c("Grueneisen volume correction");
      return std::make_shared<SteinbergGuinan>(constants, c.thermal);
    });
  } // namespace
} // namespace whipple
