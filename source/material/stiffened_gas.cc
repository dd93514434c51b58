// SPDX-License-Identifier: LGPL-2.1-or-later
#include <whipple/material/common_constants.h>
#include <whipple/material/model_registry.h>
#include <whipple/material/parameter_check.h>
#include <whipple/material/stiffened_gas.h>

namespace whipple
{
  StiffenedGas::StiffenedGas(const Constants &given_constants)
    : constants(given_constants)
  {
    require_positive(name(), "density", constants.reference_density, "g/cm^3");
    require_positive(name(), "sound speed", constants.sound_speed, "cm/us");
    require_greater(name(), "adiabatic exponent", constants.adiabatic_exponent, 1., "");
  }

  void
  StiffenedGas::evaluate(std::span<const double> true_density, std::span<const double> energy,
                         std::span<double> pressure, std::span<double> sound_speed_squared) const
  {
    const double      reference_density = constants.reference_density;
    const double      c0c0              = constants.sound_speed * constants.sound_speed;
    const double      k1                = constants.adiabatic_exponent - 1.;
    const std::size_t n                 = true_density.size();
    for (std::size_t i = 0; i < n; ++i)
      {
        const double p         = c0c0 * (true_density[i] - reference_density) + k1 * true_density[i] * energy[i];
        pressure[i]            = p;
        sound_speed_squared[i] = c0c0 + k1 * (energy[i] + p / true_density[i]);
      }
  }

  void
  StiffenedGas::derivatives(std::span<const double> true_density, std::span<const double> energy,
                            std::span<double> dp_ddensity, std::span<double> dp_de) const
  {
    const double      c0c0 = constants.sound_speed * constants.sound_speed;
    const double      k1   = constants.adiabatic_exponent - 1.;
    const std::size_t n    = true_density.size();
    for (std::size_t i = 0; i < n; ++i)
      {
        dp_ddensity[i] = c0c0 + k1 * energy[i];
        dp_de[i]       = k1 * true_density[i];
      }
  }

  double
  StiffenedGas::energy_of_pressure(double true_density, double pressure) const
  {
    check_density(true_density);
    const double c0c0 = constants.sound_speed * constants.sound_speed;
    return (pressure - c0c0 * (true_density - constants.reference_density)) /
           ((constants.adiabatic_exponent - 1.) * true_density);
  }

  double
  StiffenedGas::reference_density() const
  {
    return constants.reference_density;
  }

  std::string
  StiffenedGas::name() const
  {
    return "stiffened gas";
  }

  namespace
  {
    const Registration<EquationOfState> registration(
        {.name    = "stiffened gas",
         .summary = "liquid or soft solid: a gamma law with an offset of the pressure",
         .documentation =
             "P = (k - 1) gamma e + c0^2 (gamma - gamma0): exact Riemann solutions, no limit of compression.",
         .constants = {common_constants::density, common_constants::sound_speed, common_constants::adiabatic_exponent},
         .source    = "doc/theory/equation_of_state.md",
         .published = {}},
        [](const ModelInput &c) {
          return std::make_shared<StiffenedGas>(
              StiffenedGas::Constants{c("Density"), c("Sound speed"), c("Adiabatic exponent")});
        });
  } // namespace
} // namespace whipple
