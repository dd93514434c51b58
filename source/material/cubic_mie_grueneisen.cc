// SPDX-License-Identifier: LGPL-2.1-or-later
#include <whipple/material/common_constants.h>
#include <whipple/material/cubic_mie_grueneisen.h>
#include <whipple/material/model_registry.h>
#include <whipple/material/parameter_check.h>

#include <limits>
#include <memory>

namespace whipple
{
  namespace
  {
    bool
    rises(const CubicHugoniot &hugoniot, double chi)
    {
      return hugoniot.steepness(chi) * chi < 1. && 1. + hugoniot.rise(chi) * chi > 0.;
    }

    /// Smallest chi <= 1 beyond which the Hugoniot pressure does not rise; 1 if there is none.
    double
    end_of_hugoniot(const CubicHugoniot &hugoniot)
    {
      constexpr int steps = 10000;
      int           first = 1;
      while (first < steps && rises(hugoniot, static_cast<double>(first) / steps))
        ++first;
      if (first == steps)
        return 1.;
      double lower = (first - 1.) / steps, upper = static_cast<double>(first) / steps;
      for (double middle = 0.5 * (lower + upper); lower < middle && middle < upper; middle = 0.5 * (lower + upper))
        (rises(hugoniot, middle) ? lower : upper) = middle;
      return upper;
    }
  } // namespace

  CubicMieGrueneisen::CubicMieGrueneisen(const Constants &given_constants)
    : constants(given_constants)
  {
    require_positive(name(), "density", constants.reference_density, "g/cm^3");
    require_positive(name(), "sound speed", constants.sound_speed, "cm/us");
    require_not_negative(name(), "Hugoniot slope", constants.hugoniot.s1, "");
    require_not_negative(name(), "Grueneisen slope", constants.grueneisen_slope, "");
    require_greater(name(), "Grueneisen coefficient", constants.grueneisen, constants.grueneisen_slope, "");
    const double chi = end_of_hugoniot(constants.hugoniot);
    density_limit    = chi < 1. ? constants.reference_density / (1. - chi) : std::numeric_limits<double>::infinity();
  }

  inline CubicMieGrueneisen::Value
  CubicMieGrueneisen::value(double true_density, double energy) const
  {
    const Constants     &k          = constants;
    const double         c0c0       = k.sound_speed * k.sound_speed;
    const double         eta        = true_density / k.reference_density;
    const double         v          = k.reference_density / true_density;
    const double         grueneisen = k.grueneisen + k.grueneisen_slope * (eta - 1.);
    const ReferenceCurve reference  = reference_curve(k.hugoniot, eta, v, grueneisen);
    // What a rising Gamma gamma takes from the reference curve; 0 in expansion, as P_H is.
    const double relief = 0.5 * k.grueneisen_slope * reference.hugoniot * (1. - v);
    return {k.reference_density * (c0c0 * reference.pressure + grueneisen * energy),
            c0c0 * (reference.slope - relief) + k.grueneisen_slope * energy, k.reference_density * grueneisen};
  }

  void
  CubicMieGrueneisen::evaluate(std::span<const double> true_density, std::span<const double> energy,
                               std::span<double> pressure, std::span<double> sound_speed_squared) const
  {
    pointwise::evaluate([this](double g, double e) { return value(g, e); }, true_density, energy, pressure,
                        sound_speed_squared);
  }

  void
  CubicMieGrueneisen::derivatives(std::span<const double> true_density, std::span<const double> energy,
                                  std::span<double> dp_ddensity, std::span<double> dp_de) const
  {
    pointwise::derivatives([this](double g, double e) { return value(g, e); }, true_density, energy, dp_ddensity,
                           dp_de);
  }

  double
  CubicMieGrueneisen::energy_of_pressure(double true_density, double pressure) const
  {
    check_density(true_density);
    const Value cold = value(true_density, 0.);
    return (pressure - cold.pressure) / cold.dp_de;
  }

  double
  CubicMieGrueneisen::reference_density() const
  {
    return constants.reference_density;
  }

  double
  CubicMieGrueneisen::max_density() const
  {
    return density_limit;
  }

  std::string
  CubicMieGrueneisen::name() const
  {
    return "cubic mie-grueneisen";
  }

  namespace
  {
    PublishedConstants
    row(const char *material, double density, double c0, CubicHugoniot hugoniot, double grueneisen,
        double grueneisen_slope, const char *caution)
    {
      return {material,
              {{"Density", density},
               {"Sound speed", c0},
               {"Hugoniot slope", hugoniot.s1},
               {"Hugoniot quadratic slope", hugoniot.s2},
               {"Hugoniot cubic slope", hugoniot.s3},
               {"Grueneisen coefficient", grueneisen},
               {"Grueneisen slope", grueneisen_slope}},
              "Steinberg, UCRL-MA-106439, as typed in the Uintah material files",
              caution};
    }

    ModelDescription
    description()
    {
      const char *density_caution = "the density is a handbook value, not the source's; Gamma gamma is constant";
      return {
          .name    = "cubic mie-grueneisen",
          .summary = "solid about a curved Hugoniot, U_s = c0 + s1 u + s2 u^2/U_s + s3 u^3/U_s^2",
          .documentation =
              "The Mie-Grueneisen law for materials whose shock speed is no straight line, lead and plastics; P_H = "
              "K chi / (1 - s1 chi - s2 chi^2 - s3 chi^3)^2, Gamma gamma = (Gamma0 + b mu) gamma0. The three slopes "
              "belong together: none means anything alone. Ends at the density where the Hugoniot pressure of the "
              "fit is infinite or stops rising. Expansion and phases as in \"mie-grueneisen\".",
          .constants = {common_constants::density,
                        common_constants::sound_speed,
                        common_constants::hugoniot_slope,
                        {"Hugoniot quadratic slope", "pure number", "s2 of the term s2 u^2/U_s", Range::any(), 0.,
                         false},
                        {"Hugoniot cubic slope", "pure number", "s3 of the term s3 u^3/U_s^2", Range::any(), 0., false},
                        common_constants::grueneisen,
                        {"Grueneisen slope", "pure number", "b of Gamma gamma / gamma0 = Gamma0 + b mu, below Gamma0",
                         Range::not_negative(), 0., false}},
          .source    = "D. J. Steinberg, UCRL-MA-106439",
          .published = {row("lead", 11.34, 0.2006, {1.429, 0.8506, -1.64}, 2.74, 0.54, ""),
                        row("nylon 6/6", 1.14, 0.2208, {2.83, -3.18, 1.177}, 0.7, 0., density_caution),
                        row("polyethylene", 0.95, 0.3050, {1.328, 1.139, -1.871}, 0.67, 0., density_caution),
                        row("lexan", 1.20, 0.1933, {3.49, -8.2, 9.6}, 0.61, 0., density_caution),
                        row("lucite", 1.18, 0.2180, {2.088, -1.124, 0.}, 0.85, 0., density_caution)}};
    }

    const Registration<EquationOfState> registration(description(), [](const ModelInput &c) {
      return std::make_shared<CubicMieGrueneisen>(CubicMieGrueneisen::Constants{
          .reference_density = c("Density"),
          .sound_speed       = c("Sound speed"),
          .hugoniot          = {c("Hugoniot slope"), c("Hugoniot quadratic slope"), c("Hugoniot cubic slope")},
          .grueneisen        = c("Grueneisen coefficient"),
          .grueneisen_slope  = c("Grueneisen slope")});
    });
  } // namespace
} // namespace whipple
