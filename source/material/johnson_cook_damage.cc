// SPDX-License-Identifier: LGPL-2.1-or-later
#include <whipple/error.h>
#include <whipple/material/failure_constants.h>
#include <whipple/material/johnson_cook_constants.h>
#include <whipple/material/johnson_cook_damage.h>
#include <whipple/material/model_registry.h>
#include <whipple/material/parameter_check.h>
#include <whipple/material/thermal_blocks.h>
#include <whipple/material/thermal_constants.h>

#include <algorithm>
#include <cmath>
#include <sstream>

namespace whipple
{
  JohnsonCookDamage::JohnsonCookDamage(const Constants &constants, std::shared_ptr<const ThermalModel> thermal)
    : constants_(constants)
    , thermal_(std::move(thermal))
  {
    for (const double d : constants.d)
      if (!std::isfinite(d))
        throw InputError(name() + ": D1 ... D5 must be finite");
    require_positive(name(), "reference strain rate", constants.reference_rate, "1/us");
    std::ostringstream message;
    if (!(constants.spall_strength >= 0.))
      message << name() << ": spall strength = " << constants.spall_strength << " Mbar: must be >= 0";
    else if (!(constants.void_fraction >= 0. && constants.void_fraction < 1.))
      message << name() << ": failure void fraction = " << constants.void_fraction << ": must be >= 0 and < 1";
    if (!message.str().empty())
      throw InputError(message.str());
    require_positive(name(), "largest triaxiality", constants.largest_triaxiality, "");
    require_positive(name(), "least failure strain", constants.least_ductility, "");
    largest_triaxiality_ = constants.largest_triaxiality;
    if (const auto end = end_of_ductility())
      largest_triaxiality_ = 0.5 * *end;
    if (constants.d[4] == 0.)
      return;
    require_not_negative(name(), "reference temperature", constants.reference_temperature, "K");
    require_greater(name(), "melt temperature", constants.melt_temperature, constants.reference_temperature, "K");
    if (!thermal_)
      throw InputError("failure = '" + name() + "': needs a thermal model, or a thermal coefficient (D5) of 0");
  }

  inline double
  JohnsonCookDamage::grown(const FailureInput &state, std::size_t i, double homologous, double damage) const
  {
    const auto &d = constants_.d;
    // where nothing sound can open, voids are those of what has broken beside it
    const bool opened = !state.void_fraction.empty() && std::isfinite(constants_.spall_strength) &&
                        state.void_fraction[i] > constants_.void_fraction;
    const double tension = -state.pressure[i];
    if (opened || tension > constants_.spall_strength)
      return 1.;
    const double strain = state.plastic_increment[i], stress = state.equivalent_stress[i];
    // Flow without stress (a melt) breaks nothing, and has no ratio of stresses.
    if (!(strain > 0. && stress > 0.))
      return damage;
    const double rate        = std::max(strain / (state.dt * constants_.reference_rate), 1.);
    const double triaxiality = std::min(tension / stress, largest_triaxiality_);
    const double triaxial    = d[1] == 0. ? 0. : d[1] * std::exp(d[2] * triaxiality); // the exponential may be infinite
    const double ductility   = (d[0] + triaxial) * (1. + d[3] * std::log(rate)) * (1. + d[4] * homologous);
    return std::min(damage + strain / std::max(ductility, constants_.least_ductility), 1.);
  }

  void
  JohnsonCookDamage::advance(const FailureInput &state, std::span<double> damage) const
  {
    if (constants_.d[4] == 0.)
      {
        const std::size_t n = damage.size();
        for (std::size_t i = 0; i < n; ++i)
          damage[i] = grown(state, i, 0., damage[i]);
        return;
      }
    const double cold = constants_.reference_temperature;
    const double span = 1. / (constants_.melt_temperature - cold);
    for_each_thermal_point(*thermal_, state.density, state.energy, [&](std::size_t i, const ThermalPoint &point) {
      damage[i] = grown(state, i, std::clamp((point.temperature - cold) * span, 0., 1.), damage[i]);
    });
  }

  std::optional<double>
  JohnsonCookDamage::end_of_ductility() const
  {
    const auto  &d     = constants_.d;
    const double limit = constants_.largest_triaxiality;
    if (d[0] + d[1] * std::exp(d[2] * limit) > 0.)
      return std::nullopt;
    return d[0] < 0. && d[1] > -d[0] && d[2] < 0. ? std::log(-d[0] / d[1]) / d[2] : 0.;
  }

  bool
  JohnsonCookDamage::needs_strength() const
  {
    return true;
  }

  std::string
  JohnsonCookDamage::name() const
  {
    return "johnson-cook damage";
  }

  namespace
  {
    const std::array<const char *, 5> keys{"Johnson-Cook damage constant", "Johnson-Cook damage factor",
                                           "Johnson-Cook damage exponent", "Johnson-Cook damage rate coefficient",
                                           "Johnson-Cook damage thermal coefficient"};

    std::vector<PublishedConstants>
    published()
    {
      std::vector<PublishedConstants> result;
      for (const JohnsonCookConstants &c : johnson_cook_table())
        if (c.damage)
          {
            PublishedConstants entry{
                c.material, {{"Johnson-Cook melt temperature", c.melt_temperature}}, c.source, c.caution};
            for (std::size_t k = 0; k < keys.size(); ++k)
              entry.constants[keys[k]] = (*c.damage)[k];
            result.push_back(entry);
          }
      return result;
    }

    ModelDescription
    description()
    {
      using namespace common_constants;
      const auto number = [](const char *key, const char *text) {
        return ModelConstant{key, "pure number", text, Range::any(), {}, false};
      };
      return {.name    = "johnson-cook damage",
              .summary = "ductile failure after enough plastic strain, sooner in tension",
              .documentation =
                  "dD = d eps_p / eps_f with eps_f = [D1 + D2 exp(D3 s)](1 + D4 ln(rate/rate0))(1 + D5 T*), s = "
                  "-P/sigma_eq. "
                  "s is held at its largest value, 1.5 unless given, and at half of the s at which the fit has no "
                  "ductility left if that is within; eps_f does not fall below a least strain. D counts: strength is "
                  "lost as D nears 1. Tension of the solid beyond the spall "
                  "strength, and voids beyond a threshold in materials with a void law, are failure too. Published for "
                  "s up to "
                  "1.5; the shock-loaded material of hypervelocity impact is far outside of it. Needs strength, and a "
                  "thermal "
                  "model unless D5 is 0.",
              .constants =
                  {number(keys[0], "D1"),
                   number(keys[1], "D2"),
                   number(keys[2], "D3"),
                   number(keys[3], "D4"),
                   number(keys[4], "D5"),
                   {"Johnson-Cook melt temperature", "temperature", "at which T* is 1", Range::positive(), {}, true},
                   reference_strain_rate,
                   reference_temperature,
                   {"Johnson-Cook damage largest triaxiality", "pure number",
                    "s beyond which eps_f stays what it is there: where the fit ends", Range::positive(), 1.5, false},
                   {"Johnson-Cook damage least failure strain", "pure number", "below which eps_f does not fall",
                    Range::positive(), 0.05, false},
                   {"Spall strength",
                    "pressure",
                    "tension of the solid beyond which sound material opens; none: infinite",
                    Range::not_negative_or_infinite(),
                    {},
                    true},
                   failure_void_fraction},
              .source    = "G. R. Johnson and W. H. Cook, Engng Fract. Mech. 21 (1985) 31-48",
              .published = published()};
    }

    const Registration<FailureModel> registration(description(), [](const ModelInput &c) {
      JohnsonCookDamage::Constants constants;
      for (std::size_t k = 0; k < keys.size(); ++k)
        constants.d[k] = c(keys[k]);
      constants.reference_rate        = c("Reference strain rate");
      constants.reference_temperature = c("Reference temperature");
      if (constants.d[4] != 0.)
        constants.melt_temperature = c("Johnson-Cook melt temperature");
      constants.largest_triaxiality = c("Johnson-Cook damage largest triaxiality");
      constants.least_ductility     = c("Johnson-Cook damage least failure strain");
      constants.spall_strength      = c.find("Spall strength").value_or(std::numeric_limits<double>::infinity());
      constants.void_fraction       = c("Failure void fraction");
      return std::make_shared<JohnsonCookDamage>(constants, c.thermal);
    });
  } // namespace
} // namespace whipple
