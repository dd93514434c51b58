// SPDX-License-Identifier: LGPL-2.1-or-later
#include <whipple/material/model_registry.h>
#include <whipple/material/solid_liquid_vapour.h>

#include <algorithm>
#include <cmath>
#include <memory>
#include <vector>

namespace whipple
{
  using aluminium_phases::Fluid;
  using aluminium_phases::Solid;

  namespace
  {
    /// Temperature of the solidus by density, from zero pressure to the end of the melting curve.
    HermiteTable
    solidus_temperature(const aluminium_phases::Melting &melting)
    {
      constexpr int       steps = 1000;
      const double        first = melting.dense_density(melting.first()), last = melting.dense_density(melting.last());
      std::vector<double> temperatures;
      for (int i = 0; i <= steps; ++i)
        {
          const double density = first + i * (last - first) / steps;
          double       lower = melting.first(), upper = melting.last();
          for (double middle = 0.5 * (lower + upper); lower < middle && middle < upper; middle = 0.5 * (lower + upper))
            (melting.dense_density(middle) < density ? lower : upper) = middle;
          temperatures.push_back(lower);
        }
      return HermiteTable(first, (last - first) / steps, temperatures);
    }

    /// Boiling curve at a pressure.
    double
    boiling_parameter(const aluminium_phases::Boiling &boiling, double pressure)
    {
      double lower = boiling.first(), upper = boiling.last();
      for (double middle = 0.5 * (lower + upper); lower < middle && middle < upper; middle = 0.5 * (lower + upper))
        (boiling.tie_line(middle).pressure > pressure ? lower : upper) = middle;
      return lower;
    }
  } // namespace

  SolidLiquidVapour::SolidLiquidVapour()
    : melting(aluminium_phases::melting_curve())
    , boiling(aluminium_phases::boiling_curve())
    , release(melting, boiling)
    , solidus(solidus_temperature(melting))
  {
    constexpr double bar     = 1e-6; // in Mbar
    const auto       one_bar = boiling.tie_line(boiling_parameter(boiling, bar));
    weakening_begins         = one_bar.dense_energy.value;
    one_bar_vapour           = one_bar.light_energy.value;
    // Where the van der Waals liquid loses its last tension, T = 27/32 T_critical: tau^2 = 5/32.
    weakening_ends = boiling.tie_line(std::sqrt(5. / 32.)).dense_energy.value;
  }

  inline bool
  SolidLiquidVapour::below_solidus(double true_density, double energy, double temperature) const
  {
    if (energy < release.melt_onset)
      return true;
    return true_density >= solidus.first() &&
           (temperature <= melting.first() || true_density >= melting.dense_density(temperature));
  }

  SolidLiquidVapour::Phase
  SolidLiquidVapour::phase(double true_density, double energy) const
  {
    if (energy < release.critical_energy && true_density < release.density(energy).value)
      return energy < release.vapour_onset ? Phase::tension : Phase::boiling;
    if (below_solidus(true_density, energy, Solid::temperature(true_density, energy)))
      return Phase::solid;
    const double temperature = Fluid::temperature(true_density, energy);
    if (energy < release.melt_complete || temperature <= melting.first() ||
        true_density > melting.light_density(temperature))
      return Phase::melting;
    const bool subcritical = energy >= release.critical_energy && temperature < boiling.critical_temperature();
    if (subcritical)
      {
        const double tau = boiling.parameter(temperature);
        if (true_density > boiling.light_density(tau) && true_density < boiling.dense_density(tau))
          return Phase::boiling;
      }
    return Phase::fluid;
  }

  aluminium_phases::Melting::Mixture
  SolidLiquidVapour::melting_mixture(double true_density, double energy) const
  {
    // Solid would be hotter than the mixture, liquid colder.
    const double colder = std::max(melting.first(), Fluid::temperature(true_density, energy));
    const double hotter = std::min(melting.last(), Solid::temperature(true_density, energy));
    return melting.mixture(true_density, energy, colder, hotter);
  }

  void
  SolidLiquidVapour::add_tension(double true_density, double energy, Value &value) const
  {
    const double t = std::clamp((energy - weakening_begins) / (weakening_ends - weakening_begins), 0., 1.);
    if (t >= 1.)
      return;
    const double strength       = 1. - t * t * (3. - 2. * t);
    const double strength_slope = -6. * t * (1. - t) / (weakening_ends - weakening_begins);
    const auto   line           = release.density(energy);
    const auto   stiffness      = release.stiffness(energy);
    const double y              = true_density / line.value;
    const double mu             = y - 1.;
    const double f              = mu * (1. + mu * mu / y);
    const double slope          = 1. + mu * mu * (2. * y + 1.) / (y * y);
    value.pressure += strength * stiffness.value * f;
    value.dp_ddensity += strength * stiffness.value * slope / line.value;
    value.dp_de += (strength_slope * stiffness.value + strength * stiffness.slope) * f -
                   strength * stiffness.value * slope * y * line.slope / line.value;
  }

  SolidLiquidVapour::Value
  SolidLiquidVapour::value(double true_density, double energy) const
  {
    switch (phase(true_density, energy))
      {
      case Phase::solid:
        {
          const auto p = Solid::caloric(true_density, energy);
          return {p.pressure, p.dp_ddensity, p.dp_de};
        }
      case Phase::fluid:
        {
          const auto p = Fluid::caloric(true_density, energy);
          return {p.pressure, p.dp_ddensity, p.dp_de};
        }
      case Phase::melting:
        {
          const auto mixture = melting_mixture(true_density, energy);
          return {mixture.pressure, mixture.dp_ddensity, mixture.dp_de};
        }
      case Phase::boiling:
        {
          const auto mixture = boiling.mixture(true_density, energy, boiling.first(), boiling.last());
          Value      result{mixture.pressure, mixture.dp_ddensity, mixture.dp_de};
          add_tension(true_density, energy, result);
          return result;
        }
      case Phase::tension:
        break;
      }
    Value result{0., 0., 0.};
    add_tension(true_density, energy, result);
    return result;
  }

  void
  SolidLiquidVapour::evaluate(std::span<const double> true_density, std::span<const double> energy,
                              std::span<double> pressure, std::span<double> sound_speed_squared) const
  {
    pointwise::evaluate([this](double g, double e) { return value(g, e); }, true_density, energy, pressure,
                        sound_speed_squared);
  }

  void
  SolidLiquidVapour::derivatives(std::span<const double> true_density, std::span<const double> energy,
                                 std::span<double> dp_ddensity, std::span<double> dp_de) const
  {
    pointwise::derivatives([this](double g, double e) { return value(g, e); }, true_density, energy, dp_ddensity,
                           dp_de);
  }

  double
  SolidLiquidVapour::energy_of_pressure(double true_density, double pressure) const
  {
    check_density(true_density);
    double lower = -0.0025, upper = 0.01;
    while (value(true_density, upper).pressure < pressure && upper < 1e6)
      upper *= 2.;
    if (!(value(true_density, lower).pressure <= pressure && value(true_density, upper).pressure >= pressure))
      throw StateError(name() + ": no energy above absolute zero gives the pressure " + std::to_string(pressure) +
                       " Mbar at density " + std::to_string(true_density) + " g/cm^3");
    for (double middle = 0.5 * (lower + upper); lower < middle && middle < upper; middle = 0.5 * (lower + upper))
      (value(true_density, middle).pressure < pressure ? lower : upper) = middle;
    return upper;
  }

  SolidLiquidVapour::Thermal
  SolidLiquidVapour::thermal(double true_density, double energy) const
  {
    switch (phase(true_density, energy))
      {
      case Phase::solid:
        return {Solid::temperature(true_density, energy), 0., 0.};
      case Phase::fluid:
        return {Fluid::temperature(true_density, energy), 1., true_density < boiling.dense_density(0.) ? 1. : 0.};
      case Phase::melting:
        {
          const auto mixture = melting_mixture(true_density, energy);
          return {mixture.temperature, mixture.light_fraction, 0.};
        }
      case Phase::boiling:
        {
          const auto mixture = boiling.mixture(true_density, energy, boiling.first(), boiling.last());
          return {mixture.temperature, 1., mixture.light_fraction};
        }
      case Phase::tension:
        break;
      }
    return {release.temperature(energy), release.melt_fraction(energy), 0.};
  }

  double
  SolidLiquidVapour::melt_temperature(double true_density) const
  {
    return true_density > solidus.first() ? solidus(true_density).value : melting.first();
  }

  void
  SolidLiquidVapour::evaluate(std::span<const double> density, std::span<const double> energy,
                              const ThermalOutput &output) const
  {
    const std::size_t n = density.size();
    const bool state = !(output.temperature.empty() && output.melt_fraction.empty() && output.vapour_fraction.empty());
    for (std::size_t i = 0; state && i < n; ++i)
      {
        const Thermal result = thermal(density[i], energy[i]);
        if (!output.temperature.empty())
          output.temperature[i] = result.temperature;
        if (!output.melt_fraction.empty())
          output.melt_fraction[i] = result.melt_fraction;
        if (!output.vapour_fraction.empty())
          output.vapour_fraction[i] = result.vapour_fraction;
      }
    if (!output.melt_temperature.empty())
      for (std::size_t i = 0; i < n; ++i)
        output.melt_temperature[i] = melt_temperature(density[i]);
  }

  double
  SolidLiquidVapour::specific_heat() const
  {
    return aluminium_phases::specific_heat;
  }

  double
  SolidLiquidVapour::reference_density() const
  {
    return aluminium_phases::reference_density;
  }

  double
  SolidLiquidVapour::max_density() const
  {
    return 3. * aluminium_phases::reference_density;
  }

  ThermalModel::Transitions
  SolidLiquidVapour::transitions() const
  {
    return {release.melt_onset, release.melt_complete, weakening_begins, one_bar_vapour};
  }

  std::string
  SolidLiquidVapour::name() const
  {
    return "solid-liquid-vapour";
  }

  namespace
  {
    const char *source = "doc/theory/equation_of_state.md, fitted to S. L. Thompson and H. S. Lauson, SC-RR-71 0714 "
                         "(1972), ANEOS library aluminium";

    ModelDescription
    description()
    {
      return {.name          = "solid-liquid-vapour",
              .summary       = "aluminium that melts and boils, with the melting point and Hugoniot of ANEOS",
              .documentation = "Free energies of solid and of fluid, phases in equilibrium: melting from 0.67 to 1.06 "
                               "MJ/kg at zero pressure, 956 K; valid up to 8.1 g/cm^3. Condensed material bears "
                               "tension and opens voids; boiling liquid loses that strength and vapour fills its "
                               "space. Vapour keeps the specific heat 3R of the solid and its critical point is low, "
                               "6910 K: use other laws where vapour decides.",
              .constants     = {},
              .source        = source,
              .published     = {{"aluminium", {}, source, ""}}};
    }

    const Registration<EquationOfState> registration(description(), [](const ModelInput &) {
      return std::make_shared<SolidLiquidVapour>();
    });
  } // namespace
} // namespace whipple
