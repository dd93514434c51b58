// SPDX-License-Identifier: LGPL-2.1-or-later
#include <whipple/material/model_registry.h>
#include <whipple/material/tabulated.h>

#include <algorithm>
#include <cmath>
#include <sstream>

namespace whipple
{
  Tabulated::Tabulated(const std::string &path)
    : Tabulated(read_equation_of_state_table(path))
  {
  }

  Tabulated::Tabulated(const EquationOfStateTable &table)
    : table_(table)
    , lowest_energy_(table.density, table.lowest_energy, smooth_slopes(table.density, table.lowest_energy))
    , pressure_(table.density, table.heat, table.pressure)
  {
    if (!table.temperature.empty())
      temperature_.emplace(table.density, table.heat, table.temperature);
    check_at_rest();
  }

  void
  Tabulated::check_at_rest() const
  {
    // 1 m/s and 100 km/s: slower than any gas, faster than any solid
    constexpr double   slowest = 1e-4, fastest = 10.;
    BicubicTable::Cell cell;
    const double       true_density = table_.reference_density;
    const State        rest         = state(true_density, 0., cell);
    const double       c2           = rest.dp_ddensity + rest.pressure / (true_density * true_density) * rest.dp_de;
    if (!(c2 >= slowest * slowest && c2 <= fastest * fastest))
      {
        std::ostringstream value;
        value << c2;
        throw InputError(table_.path, "square of the sound speed at reference_density and reference_energy, cm^2/us^2",
                         value.str(), "must be in 1e-8 ... 100, as that of a state in which matter can rest");
      }
  }

  inline Tabulated::State
  Tabulated::state(double true_density, double energy, BicubicTable::Cell &hint) const
  {
    hint.i                             = find_interval(table_.density, true_density, hint.i);
    const PiecewiseCubic::Point lowest = lowest_energy_.at(true_density, hint.i);
    const BicubicTable::Point   p      = pressure_.at(true_density, energy - lowest.value, hint);
    return {p.value, p.dx - p.dy * lowest.slope, p.dy};
  }

  void
  Tabulated::evaluate(std::span<const double> true_density, std::span<const double> energy, std::span<double> pressure,
                      std::span<double> sound_speed_squared) const
  {
    BicubicTable::Cell cell;
    pointwise::evaluate([&](double g, double e) { return state(g, e, cell); }, true_density, energy, pressure,
                        sound_speed_squared);
  }

  void
  Tabulated::derivatives(std::span<const double> true_density, std::span<const double> energy,
                         std::span<double> dp_ddensity, std::span<double> dp_de) const
  {
    BicubicTable::Cell cell;
    pointwise::derivatives([&](double g, double e) { return state(g, e, cell); }, true_density, energy, dp_ddensity,
                           dp_de);
  }

  double
  Tabulated::energy_of_pressure(double true_density, double pressure) const
  {
    check_density(true_density);
    const double lowest = lowest_energy_.at(true_density).value;
    if (const auto heat = pressure_.find_y(true_density, pressure, -lowest))
      return lowest + *heat;
    std::ostringstream message;
    message << name() << " (" << table_.path << "): at density " << true_density
            << " g/cm^3 no energy gives a pressure of " << pressure << " Mbar";
    throw StateError(message.str());
  }

  double
  Tabulated::reference_density() const
  {
    return table_.reference_density;
  }

  double
  Tabulated::bilinear(const std::vector<double> &values, double true_density, double heat) const
  {
    const std::vector<double> &x = table_.density, &y = table_.heat;
    const std::size_t          i = find_interval(x, true_density, 0), j = find_interval(y, heat, 0), m = y.size();
    const double               s = std::clamp((true_density - x[i]) / (x[i + 1] - x[i]), 0., 1.);
    const double               t = std::clamp((heat - y[j]) / (y[j + 1] - y[j]), 0., 1.);
    return (1. - s) * ((1. - t) * values[i * m + j] + t * values[i * m + j + 1]) +
           s * ((1. - t) * values[(i + 1) * m + j] + t * values[(i + 1) * m + j + 1]);
  }

  void
  Tabulated::evaluate(std::span<const double> density, std::span<const double> energy,
                      const ThermalOutput &output) const
  {
    BicubicTable::Cell cell;
    for (std::size_t i = 0; i < density.size(); ++i)
      {
        const double heat = energy[i] - lowest_energy_.at(density[i]).value;
        if (!output.temperature.empty())
          output.temperature[i] = temperature_->at(density[i], std::max(heat, 0.), cell).value;
        if (!output.melt_fraction.empty())
          output.melt_fraction[i] =
              table_.melt_fraction.empty() ? 0. : bilinear(table_.melt_fraction, density[i], heat);
        if (!output.vapour_fraction.empty())
          output.vapour_fraction[i] =
              table_.vapour_fraction.empty() ? 0. : bilinear(table_.vapour_fraction, density[i], heat);
        if (!output.melt_temperature.empty())
          {
            const std::vector<double> &melt = table_.melt_temperature, &x = table_.density;
            const std::size_t          k     = find_interval(x, density[i], 0);
            const double               share = std::clamp((density[i] - x[k]) / (x[k + 1] - x[k]), 0., 1.);
            output.melt_temperature[i] =
                melt.empty() ? std::numeric_limits<double>::infinity() : (1. - share) * melt[k] + share * melt[k + 1];
          }
      }
  }

  double
  Tabulated::specific_heat() const
  {
    BicubicTable::Cell cell;
    const double       true_density = table_.reference_density, heat = -lowest_energy_.at(true_density).value;
    return 1. / temperature_->at(true_density, std::max(heat, 0.), cell).dy;
  }

  ThermalModel::Transitions
  Tabulated::transitions() const
  {
    constexpr double infinity = std::numeric_limits<double>::infinity();
    Transitions      result{infinity, infinity, infinity, infinity};
    // the condensed branch of P_s = 0: from the reference density down to the first density without pressure
    const auto unstressed = [this](double energy) {
      BicubicTable::Cell cell;
      double             high = table_.reference_density;
      for (double low = 0.99 * high; low > table_.density.front(); high = low, low *= 0.99)
        if (state(low, energy, cell).pressure <= 0.)
          {
            for (int i = 0; i < 50; ++i)
              {
                const double middle                                       = 0.5 * (low + high);
                (state(middle, energy, cell).pressure <= 0. ? low : high) = middle;
              }
            return high;
          }
      return table_.density.front();
    };
    const auto note = [](double fraction, double energy, double &onset, double &complete) {
      if (fraction > 0. && onset == infinity)
        onset = energy;
      if (fraction >= 1. && complete == infinity)
        complete = energy;
    };
    constexpr int steps = 4096;
    for (int k = 0; k <= steps; ++k)
      {
        const double energy = table_.heat.back() * k / steps, true_density = unstressed(energy);
        const double heat = energy - lowest_energy_.at(true_density).value;
        if (!table_.melt_fraction.empty())
          note(bilinear(table_.melt_fraction, true_density, heat), energy, result.melt_onset, result.melt_complete);
        if (!table_.vapour_fraction.empty())
          note(bilinear(table_.vapour_fraction, true_density, heat), energy, result.vapour_onset,
               result.vapour_complete);
      }
    return result;
  }

  Tabulated::Inconsistency
  Tabulated::inconsistency() const
  {
    Inconsistency       result{0., table_.density.front(), table_.lowest_energy.front(), 0.};
    std::vector<double> all;
    BicubicTable::Cell  cell;
    for (std::size_t i = 0; i + 1 < table_.density.size(); ++i)
      for (std::size_t j = 0; j + 1 < table_.heat.size(); ++j)
        {
          const double true_density = 0.5 * (table_.density[i] + table_.density[i + 1]);
          const double heat         = 0.5 * (table_.heat[j] + table_.heat[j + 1]);
          const auto   lowest       = lowest_energy_.at(true_density);
          const State  p            = state(true_density, lowest.value + heat, cell);
          const auto   t            = temperature_->at(true_density, heat, cell);
          if (!(p.pressure > 0.))
            continue;
          const double a = true_density * true_density * (t.dx - t.dy * lowest.slope), b = p.pressure * t.dy,
                       c         = t.value * p.dp_de;
          const double violation = std::abs(a + b - c) / (std::abs(a) + std::abs(b) + std::abs(c));
          all.push_back(violation);
          if (violation > result.largest)
            result = {violation, true_density, lowest.value + heat, 0.};
        }
    if (!all.empty())
      {
        std::nth_element(all.begin(), all.begin() + all.size() / 2, all.end());
        result.median = all[all.size() / 2];
      }
    return result;
  }

  std::string
  Tabulated::name() const
  {
    return "tabulated";
  }

  namespace
  {
    ModelDescription
    description()
    {
      return {
          .name    = "tabulated",
          .summary = "pressure from a table in an HDF5 file",
          .documentation =
              "Monotone bicubic interpolation of P_s over density and energy, with a continuous sound speed from the "
              "derivatives of the same interpolant; linear continuation beyond the table. The reference density is the "
              "table's. scripts/convert_eos_table.py makes such files of SESAME text.",
          .constants = {{.key           = "Table",
                         .quantity      = "text",
                         .documentation = "HDF5 file, layout in doc/theory/equation_of_state_tables.md",
                         .default_value = {}}},
          .source    = "F. N. Fritsch and R. E. Carlson, SIAM J. Numer. Anal. 17 (1980) 238-246; the table's own",
          .published = {}};
    }

    const Registration<EquationOfState> registration(description(), [](const ModelInput &c) {
      return std::make_shared<Tabulated>(c.text("Table"));
    });
  } // namespace
} // namespace whipple
