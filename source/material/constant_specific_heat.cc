// SPDX-License-Identifier: LGPL-2.1-or-later
#include <whipple/error.h>
#include <whipple/material/common_constants.h>
#include <whipple/material/constant_specific_heat.h>
#include <whipple/material/lindemann_melting.h>
#include <whipple/material/model_registry.h>
#include <whipple/material/parameter_check.h>
#include <whipple/material/phase_constants.h>
#include <whipple/material/thermal_constants.h>
#include <whipple/material/zero_pressure.h>

#include <algorithm>
#include <array>
#include <cmath>
#include <optional>
#include <sstream>

namespace whipple
{
  namespace
  {
    // Boiling sets in over this much expansion, not at once: no temperature jumps where a cell expands into it. Liquid
    // metals boil below a critical pressure that is less than 1 % of their bulk modulus.
    constexpr double boiling_width = 0.02; // of gamma0 / gamma

    constexpr int melt_intervals = 1024;
  } // namespace

  ConstantSpecificHeat::ConstantSpecificHeat(const EquationOfState &eos, const Constants &constants)
    : constants_(constants)
    , reference_density_(eos.reference_density())
    , isentrope_(eos, constants.specific_heat, constants.reference_temperature)
  {
    require_positive(name(), "specific heat", constants.specific_heat, "Mbar cm^3/(g K)");
    require_not_negative(name(), "reference temperature", constants.reference_temperature, "K");
    if (constants.melting_point != infinite)
      set_melting(eos);
    if (constants.boiling_point != infinite)
      set_boiling(eos);
  }

  std::optional<ConstantSpecificHeat::ZeroPressure>
  ConstantSpecificHeat::reach(const EquationOfState &eos, double wanted) const
  {
    const auto reached = [&](double energy) -> std::optional<bool> {
      const auto v = zero_pressure_volume(eos, energy, isentrope_.upper());
      return v ? std::optional(point(*v, energy).temperature >= wanted) : std::nullopt;
    };
    double low = 0., high = constants_.specific_heat * (wanted - constants_.reference_temperature);
    for (;; low = high, high *= 1.1)
      {
        const auto there = reached(high);
        if (!there || !std::isfinite(high))
          return std::nullopt;
        if (*there)
          break;
      }
    for (int i = 0; i < 100; ++i)
      {
        const double middle             = 0.5 * (low + high);
        (*reached(middle) ? high : low) = middle;
      }
    return ZeroPressure{*zero_pressure_volume(eos, high, isentrope_.upper()), high};
  }

  void
  ConstantSpecificHeat::set_melting(const EquationOfState &eos)
  {
    require_greater(name(), "melting point", constants_.melting_point, constants_.reference_temperature, "K");
    require_positive(name(), "heat of fusion", constants_.heat_of_fusion, "Mbar cm^3/g");
    const auto onset = reach(eos, constants_.melting_point);
    if (!onset)
      {
        std::ostringstream message;
        message << name() << ": melting point = " << constants_.melting_point << " K: the equation of state '"
                << eos.name() << "' does not get there without pressure; set it to infinite";
        throw InputError(message.str());
      }

    // The melting law is scaled to meet the melting point where the solid gets there, expanded by the heat.
    const LindemannMelting        law{constants_.grueneisen, constants_.volume_correction};
    const double                  scale = constants_.melting_point / law(onset->v);
    const double                  step  = (onset->v - isentrope_.lower()) / melt_intervals;
    std::vector<CubicTable::Node> nodes(melt_intervals + 1);
    for (int i = 0; i <= melt_intervals; ++i)
      {
        const double v     = isentrope_.lower() + i * step;
        const double value = scale * law(v);
        nodes[i]           = {value, value * law.logarithmic_slope(v)};
      }
    melt_temperature_ = CubicTable(isentrope_.lower(), onset->v, nodes);

    transitions_.melt_onset    = onset->energy;
    transitions_.melt_complete = onset->energy + constants_.heat_of_fusion;
    const auto v               = zero_pressure_volume(eos, transitions_.melt_complete, isentrope_.upper());
    // Part of the heat of fusion at zero pressure goes into the expansion of the law between the two states.
    fusion_ = constants_.specific_heat *
              (isentrope_.temperature(v.value_or(onset->v), transitions_.melt_complete) - constants_.melting_point);
    melting_volume_ = onset->v;
    melting_point_  = constants_.melting_point;
    require_positive(name(), "heat of fusion at constant density", fusion_, "Mbar cm^3/g");
  }

  void
  ConstantSpecificHeat::set_boiling(const EquationOfState &eos)
  {
    if (!(melting_point_ < infinite))
      throw InputError(name() + ": a boiling point needs a melting point");
    require_greater(name(), "boiling point", constants_.boiling_point, melting_point_, "K");
    require_positive(name(), "heat of vaporisation", constants_.heat_of_vaporisation, "Mbar cm^3/g");
    const auto onset = reach(eos, constants_.boiling_point);
    if (!onset)
      return; // the liquid of this law pulls itself apart before it is that hot
    transitions_.vapour_onset    = onset->energy;
    transitions_.vapour_complete = onset->energy + constants_.heat_of_vaporisation;
    boiling_volume_              = onset->v;
    const auto   v               = zero_pressure_volume(eos, transitions_.vapour_complete, isentrope_.upper());
    const double rest =
        v ? constants_.specific_heat * (point(*v, transitions_.vapour_complete).temperature - constants_.boiling_point)
          : 0.;
    // A law that holds its vapour together spends part of the heat on that. One that lets go of it (Tillotson), or that
    // would spend more than there is (linear polynomial far out), gets the whole.
    vaporisation_  = rest > 0. ? rest : constants_.heat_of_vaporisation;
    boiling_point_ = constants_.boiling_point;
  }

  inline ConstantSpecificHeat::Point
  ConstantSpecificHeat::point(double v, double energy) const
  {
    const double cv        = constants_.specific_heat;
    const double unchanged = isentrope_.temperature(v, energy);
    const bool   melts     = melting_point_ < infinite;
    const double melting   = melts ? melt_temperature_(v) : infinite;
    const double above     = std::max(cv * (unchanged - melting), 0.);
    const double fraction  = std::min(above / fusion_, 1.);
    const double molten    = std::min(unchanged, melting) + std::max(above - fusion_, 0.) / cv;

    const double s      = std::clamp((v - boiling_volume_) / boiling_width + 1., 0., 1.);
    const double share  = s * s * (3. - 2. * s);
    const double boiled = std::min(share * cv * std::max(molten - boiling_point_, 0.), vaporisation_);
    return {molten - boiled / cv, melting, fraction, boiled / vaporisation_};
  }

  void
  ConstantSpecificHeat::evaluate(std::span<const double> density, std::span<const double> energy,
                                 const ThermalOutput &output) const
  {
    constexpr std::size_t          block_size = 256;
    std::array<double, block_size> temperature, melt_temperature, melt_fraction, vapour_fraction;
    const std::size_t              n = density.size();
    for (std::size_t first = 0; first < n; first += block_size)
      {
        const std::size_t size = std::min(block_size, n - first);
        for (std::size_t i = 0; i < size; ++i)
          {
            const Point p       = point(reference_density_ / density[first + i], energy[first + i]);
            temperature[i]      = p.temperature;
            melt_temperature[i] = p.melt_temperature;
            melt_fraction[i]    = p.melt_fraction;
            vapour_fraction[i]  = p.vapour_fraction;
          }
        const auto write = [&](const auto &values, std::span<double> wanted) {
          if (!wanted.empty())
            std::copy_n(values.begin(), size, wanted.begin() + first);
        };
        write(temperature, output.temperature);
        write(melt_temperature, output.melt_temperature);
        write(melt_fraction, output.melt_fraction);
        write(vapour_fraction, output.vapour_fraction);
      }
  }

  double
  ConstantSpecificHeat::specific_heat() const
  {
    return constants_.specific_heat;
  }

  ThermalModel::Transitions
  ConstantSpecificHeat::transitions() const
  {
    return transitions_;
  }

  std::string
  ConstantSpecificHeat::name() const
  {
    return "constant specific heat";
  }

  namespace
  {
    ModelDescription
    description()
    {
      using namespace common_constants;
      const Range never_or_positive{.lower = 0., .lower_excluded = true, .infinite = true};
      return {
          .name    = "constant specific heat",
          .summary = "temperature of any equation of state, with melting and boiling",
          .documentation =
              "T = T_ref + (e - e_T(gamma)) / cv, e_T the isotherm of the equation of state through its reference "
              "state, "
              "found from its isentrope. The melting point follows the density by Lindemann's rule in Steinberg and "
              "Guinan's form, scaled so that the solid melts at its melting point where it is without pressure. The "
              "heat of "
              "fusion melts at constant temperature; in expanded states the heat of vaporisation boils likewise. The "
              "pressure knows of none of it. A specific heat near 300 K makes the onset of melting of aluminium come 8 "
              "% "
              "early in energy. A material without a melting point has no phases.",
          .constants =
              {specific_heat,
               reference_temperature,
               {"Melting point", "temperature", "at zero pressure; infinite: never melts", never_or_positive, {}, true},
               {"Heat of fusion", "specific energy", "at zero pressure", Range::positive(), {}, true},
               {"Boiling point", "temperature", "at zero pressure; infinite: never boils", never_or_positive, {}, true},
               {"Heat of vaporisation", "specific energy", "at zero pressure", Range::positive(), {}, true},
               {"Grueneisen coefficient", "pure number", "Gamma0 at gamma0", Range::positive(), {}, true},
               volume_correction},
          .source    = "thermodynamics: doc/theory/melting.md; melting law: D. J. Steinberg, S. G. Cochran and M. W. "
                       "Guinan, J. Appl. Phys. 51 (1980) 1498-1504",
          .published = phase_constants()};
    }

    const Registration<ThermalModel> registration(description(), [](const ModelInput &c) {
      ConstantSpecificHeat::Constants constants;
      constants.specific_heat         = c("Specific heat");
      constants.reference_temperature = c("Reference temperature");
      constexpr double never          = std::numeric_limits<double>::infinity();
      constants.melting_point         = c.find("Melting point").value_or(never);
      constants.boiling_point         = c.find("Boiling point").value_or(never);
      if (constants.melting_point < never)
        {
          constants.heat_of_fusion    = c("Heat of fusion");
          constants.grueneisen        = c("Grueneisen coefficient");
          constants.volume_correction = c("Grueneisen volume correction");
        }
      if (constants.boiling_point < never)
        constants.heat_of_vaporisation = c("Heat of vaporisation");
      return std::make_shared<ConstantSpecificHeat>(*c.equation_of_state, constants);
    });
  } // namespace
} // namespace whipple
