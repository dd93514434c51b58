// SPDX-License-Identifier: LGPL-2.1-or-later
#include <whipple/material/common_constants.h>
#include <whipple/material/model_registry.h>
#include <whipple/material/parameter_check.h>
#include <whipple/material/tillotson.h>

#include <algorithm>
#include <cmath>
#include <memory>

namespace whipple
{
  Tillotson::Tillotson(const Constants &given_constants)
    : constants(given_constants)
  {
    require_positive(name(), "density", constants.reference_density, "g/cm^3");
    require_positive(name(), "hot Grueneisen coefficient", constants.hot_grueneisen, "");
    require_not_negative(name(), "cold Grueneisen coefficient", constants.cold_grueneisen, "");
    require_positive(name(), "bulk modulus", constants.bulk_modulus, "Mbar");
    require_not_negative(name(), "quadratic modulus", constants.quadratic_modulus, "Mbar");
    require_positive(name(), "reference energy", constants.reference_energy, "Mbar cm^3/g");
    require_not_negative(name(), "thermal decay", constants.thermal_decay, "");
    require_not_negative(name(), "cohesive decay", constants.cohesive_decay, "");
    require_positive(name(), "incipient vaporisation energy", constants.incipient_vaporisation_energy, "Mbar cm^3/g");
    require_greater(name(), "complete vaporisation energy", constants.complete_vaporisation_energy,
                    constants.incipient_vaporisation_energy, "Mbar cm^3/g");
  }

  inline Tillotson::Value
  Tillotson::condensed(double true_density, double energy) const
  {
    const Constants &k     = constants;
    const double     eta   = true_density / k.reference_density;
    const double     mu    = eta - 1.;
    const double     x     = k.reference_energy * eta * eta;
    const double     heat  = std::abs(energy);
    const double     one_w = x / (x + heat); // 1/w, also at gamma = 0
    // A mu + B mu^2 in compression; A mu / (1 - mu B/A) in expansion. One of the two parts is zero.
    const double compression = std::max(mu, 0.);
    const double tension     = std::min(mu, 0.);
    const double softening   = 1. / (1. - tension * k.quadratic_modulus / k.bulk_modulus);
    const double cold        = mu * (k.bulk_modulus * softening + k.quadratic_modulus * compression);
    const double cold_slope  = k.bulk_modulus * softening * softening + 2. * k.quadratic_modulus * compression;
    // d(1/w)/dgamma = (2/gamma) (1/w) (1 - 1/w), d(e/w)/de = 1/w^2
    const double thermal = k.hot_grueneisen + k.cold_grueneisen * one_w;
    return {thermal * true_density * energy + cold,
            (thermal + 2. * k.cold_grueneisen * one_w * (1. - one_w)) * energy + cold_slope / k.reference_density,
            true_density * (k.hot_grueneisen + k.cold_grueneisen * one_w * one_w)};
  }

  Tillotson::Value
  Tillotson::expanded(double true_density, double energy) const
  {
    const Constants &k     = constants;
    const double     eta   = true_density / k.reference_density;
    const double     z     = 1. / eta - 1.;
    const double     dz    = -1. / (eta * true_density);
    const double     x     = k.reference_energy * eta * eta;
    const double     one_w = x / (x + energy);
    const Value      p1    = condensed(true_density, energy);

    const double fade          = std::exp(-k.thermal_decay * z * z);
    const double fade_slope    = -2. * k.thermal_decay * z * dz;
    const double cohesion      = k.bulk_modulus * std::exp(-k.cohesive_decay * z);
    const double bracket       = k.cold_grueneisen * true_density * energy * one_w + cohesion * (eta - 1.);
    const double bracket_slope = k.cold_grueneisen * energy * one_w * (3. - 2. * one_w) +
                                 cohesion * (1. / k.reference_density - (eta - 1.) * k.cohesive_decay * dz);
    const Value p2{k.hot_grueneisen * true_density * energy + bracket * fade,
                   k.hot_grueneisen * energy + (bracket_slope + bracket * fade_slope) * fade,
                   true_density * (k.hot_grueneisen + k.cold_grueneisen * one_w * one_w * fade)};

    const double width = k.complete_vaporisation_energy - k.incipient_vaporisation_energy;
    const double t     = std::clamp((energy - k.incipient_vaporisation_energy) / width, 0., 1.);
    const double s     = t * t * (3. - 2. * t);
    const double ds_de = 6. * t * (1. - t) / width;
    return {p1.pressure + s * (p2.pressure - p1.pressure), p1.dp_ddensity + s * (p2.dp_ddensity - p1.dp_ddensity),
            p1.dp_de + s * (p2.dp_de - p1.dp_de) + ds_de * (p2.pressure - p1.pressure)};
  }

  void
  Tillotson::evaluate(std::span<const double> true_density, std::span<const double> energy, std::span<double> pressure,
                      std::span<double> sound_speed_squared) const
  {
    const auto store = [&](std::size_t i, const Value &value) {
      pressure[i]            = value.pressure;
      sound_speed_squared[i] = value.dp_ddensity + value.pressure / (true_density[i] * true_density[i]) * value.dp_de;
    };
    // The exponentials of the few cells with vapour stay out of the loop that vectorises.
    const std::size_t n = true_density.size();
    for (std::size_t i = 0; i < n; ++i)
      store(i, condensed(true_density[i], energy[i]));
    for (std::size_t i = 0; i < n; ++i)
      if (has_vapour(true_density[i], energy[i]))
        store(i, expanded(true_density[i], energy[i]));
  }

  void
  Tillotson::derivatives(std::span<const double> true_density, std::span<const double> energy,
                         std::span<double> dp_ddensity, std::span<double> dp_de) const
  {
    const auto store = [&](std::size_t i, const Value &value) {
      dp_ddensity[i] = value.dp_ddensity;
      dp_de[i]       = value.dp_de;
    };
    const std::size_t n = true_density.size();
    for (std::size_t i = 0; i < n; ++i)
      store(i, condensed(true_density[i], energy[i]));
    for (std::size_t i = 0; i < n; ++i)
      if (has_vapour(true_density[i], energy[i]))
        store(i, expanded(true_density[i], energy[i]));
  }

  double
  Tillotson::energy_of_pressure(double true_density, double pressure) const
  {
    check_density(true_density);
    const auto residual = [&](double energy) {
      const Value value =
          has_vapour(true_density, energy) ? expanded(true_density, energy) : condensed(true_density, energy);
      return value.pressure - pressure;
    };
    // P ~ a gamma e far out on both sides.
    double lower = -constants.reference_energy, upper = constants.reference_energy;
    while (residual(lower) > 0.)
      lower *= 2.;
    while (residual(upper) < 0.)
      upper *= 2.;
    if (!std::isfinite(residual(lower) + residual(upper)))
      throw StateError(name() + ": no energy gives the pressure " + std::to_string(pressure) + " Mbar at density " +
                       std::to_string(true_density) + " g/cm^3");
    while (true)
      {
        const double middle = 0.5 * (lower + upper);
        if (!(lower < middle && middle < upper))
          return std::abs(residual(lower)) < std::abs(residual(upper)) ? lower : upper;
        (residual(middle) < 0. ? lower : upper) = middle;
      }
  }

  double
  Tillotson::reference_density() const
  {
    return constants.reference_density;
  }

  std::string
  Tillotson::name() const
  {
    return "tillotson";
  }

  namespace
  {
    constexpr double erg_per_g   = 1e-12; // in Mbar cm^3/g
    constexpr double dyn_per_cm2 = 1e-12; // in Mbar
    const char      *spheral     = "Spheral's library of materials (MaterialPropertiesLib.py)";

    /// A row of the usual tables, in their order and units (CGS).
    PublishedConstants
    row(const char *material, double density, double a, double b, double A, double B, double E0, double alpha,
        double beta, double E_iv, double E_cv, const char *source, const char *caution)
    {
      return {material,
              {{"Density", density},
               {"Tillotson hot Grueneisen coefficient", a},
               {"Tillotson cold Grueneisen coefficient", b},
               {"Tillotson bulk modulus", A * dyn_per_cm2},
               {"Tillotson quadratic modulus", B * dyn_per_cm2},
               {"Tillotson reference energy", E0 * erg_per_g},
               {"Tillotson thermal decay", alpha},
               {"Tillotson cohesive decay", beta},
               {"Tillotson incipient vaporisation energy", E_iv * erg_per_g},
               {"Tillotson complete vaporisation energy", E_cv * erg_per_g}},
              source,
              caution};
    }

    ModelDescription
    description()
    {
      return {
          "tillotson",
          "Tillotson's law: condensed solid and vapour, joined over the energies of vaporisation",
          "P1 = (a + b/w) gamma e + A mu + B mu^2 (A mu/(1 - mu B/A) in expansion) for condensed material, P2 = a "
          "gamma e + [b gamma e / w + A mu "
          "exp(-beta z)] exp(-alpha z^2) for expanded vapour, w = 1 + |e|/(E0 eta^2), z = 1/eta - 1; between E_iv and "
          "E_cv a smooth mean of both, so that the sound speed has no jump. Cold expanded material "
          "is in tension and opens voids; vapour pushes at every density and closes them. It has no temperature and "
          "does not melt.",
          {common_constants::density,
           {"Tillotson hot Grueneisen coefficient", "pure number", "a, k - 1 of the vapour", Range::positive(), {}},
           {"Tillotson cold Grueneisen coefficient",
            "pure number",
            "b, Gamma of the cold solid less a",
            Range::not_negative(),
            {}},
           {"Tillotson bulk modulus", "pressure", "A", Range::positive(), {}},
           {"Tillotson quadratic modulus", "pressure", "B, in compression", Range::not_negative(), {}},
           {"Tillotson reference energy", "specific energy", "E0", Range::positive(), {}},
           {"Tillotson thermal decay", "pure number", "alpha", Range::not_negative(), {}},
           {"Tillotson cohesive decay", "pure number", "beta", Range::not_negative(), {}},
           {"Tillotson incipient vaporisation energy", "specific energy", "E_iv", Range::positive(), {}},
           {"Tillotson complete vaporisation energy", "specific energy", "E_cv, above E_iv", Range::positive(), {}}},
          "J. H. Tillotson, General Atomic report GA-3216 (1962)",
          {row("aluminium", 2.70, 0.5, 1.63, 0.752e12, 0.65e12, 5e10, 5., 5., 3.00e10, 1.39e11,
               "H. J. Melosh, Impact Cratering (1989), as typed in the file aluminum.till.cfg", ""),
           row("copper", 8.90, 0.5, 1.5, 1.39e12, 1.10e12, 3.25e11, 5., 5., 1.35e10, 3.00e10, spheral, ""),
           row("iron", 7.86, 0.5, 1.5, 1.28e12, 1.05e12, 9.5e10, 5., 5., 1.42e10, 8.45e10, spheral,
               "Melosh (1989) has density 7.80 g/cm^3, E_iv 2.40 MJ/kg, E_cv 8.67 MJ/kg"),
           row("nylon", 1.185, 0.6, 2.0, 1.01e11, 3.38e11, 7e10, 10., 5., 2e10, 2.4e10, spheral, ""),
           row("water", 0.998, 0.7, 0.15, 2.18e10, 13.25e10, 7e10, 10., 5., 4.19e9, 2.69e10, spheral, ""),
           row("granite", 2.68, 0.5, 1.3, 1.8e11, 1.8e11, 1.6e11, 5., 5., 3.5e10, 1.8e11, spheral, "")}};
    }

    const Registration<EquationOfState> registration(description(), [](const ModelInput &c) {
      return std::make_shared<Tillotson>(
          Tillotson::Constants{.reference_density             = c("Density"),
                               .hot_grueneisen                = c("Tillotson hot Grueneisen coefficient"),
                               .cold_grueneisen               = c("Tillotson cold Grueneisen coefficient"),
                               .bulk_modulus                  = c("Tillotson bulk modulus"),
                               .quadratic_modulus             = c("Tillotson quadratic modulus"),
                               .reference_energy              = c("Tillotson reference energy"),
                               .thermal_decay                 = c("Tillotson thermal decay"),
                               .cohesive_decay                = c("Tillotson cohesive decay"),
                               .incipient_vaporisation_energy = c("Tillotson incipient vaporisation energy"),
                               .complete_vaporisation_energy  = c("Tillotson complete vaporisation energy")});
    });
  } // namespace
} // namespace whipple
