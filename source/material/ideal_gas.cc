// SPDX-License-Identifier: LGPL-2.1-or-later
#include <whipple/material/common_constants.h>
#include <whipple/material/ideal_gas.h>
#include <whipple/material/model_registry.h>
#include <whipple/material/parameter_check.h>

namespace whipple
{
  IdealGas::IdealGas(double adiabatic_exponent, double reference_density)
    : exponent_minus_1(adiabatic_exponent - 1.)
    , reference_density_(reference_density)
  {
    require_greater(name(), "adiabatic exponent", adiabatic_exponent, 1., "");
    require_positive(name(), "density", reference_density, "g/cm^3");
  }

  void
  IdealGas::evaluate(std::span<const double> true_density, std::span<const double> energy, std::span<double> pressure,
                     std::span<double> sound_speed_squared) const
  {
    const double      k1 = exponent_minus_1;
    const double      kk = (k1 + 1.) * k1;
    const std::size_t n  = true_density.size();
    for (std::size_t i = 0; i < n; ++i)
      {
        pressure[i]            = k1 * true_density[i] * energy[i];
        sound_speed_squared[i] = kk * energy[i];
      }
  }

  void
  IdealGas::derivatives(std::span<const double> true_density, std::span<const double> energy,
                        std::span<double> dp_ddensity, std::span<double> dp_de) const
  {
    const double      k1 = exponent_minus_1;
    const std::size_t n  = true_density.size();
    for (std::size_t i = 0; i < n; ++i)
      {
        dp_ddensity[i] = k1 * energy[i];
        dp_de[i]       = k1 * true_density[i];
      }
  }

  double
  IdealGas::energy_of_pressure(double true_density, double pressure) const
  {
    check_density(true_density);
    return pressure / (exponent_minus_1 * true_density);
  }

  double
  IdealGas::reference_density() const
  {
    return reference_density_;
  }

  std::string
  IdealGas::name() const
  {
    return "ideal gas";
  }

  namespace
  {
    const Registration<EquationOfState> registration(
        {.name          = "ideal gas",
         .summary       = "gamma law",
         .documentation = "P = (k - 1) gamma e. The density is only a typical one, for bodies that name none.",
         .constants     = {common_constants::adiabatic_exponent, common_constants::density},
         .source        = "doc/theory/equation_of_state.md",
         .published     = {}},
        [](const ModelInput &c) { return std::make_shared<IdealGas>(c("Adiabatic exponent"), c("Density")); });
  } // namespace
} // namespace whipple
