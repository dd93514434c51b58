// SPDX-License-Identifier: LGPL-2.1-or-later
#include <whipple/material/isothermal.h>

#include <algorithm>
#include <array>
#include <cmath>
#include <sstream>
#include <utility>

namespace whipple
{
  namespace
  {
    /// The law inside is fed zeros from here, a block of cells at a time.
    constexpr std::array<double, 256> no_energy{};

    template <class Kernel>
    void
    in_blocks(std::size_t n, const Kernel &kernel)
    {
      for (std::size_t start = 0; start < n; start += no_energy.size())
        {
          const std::size_t length = std::min(no_energy.size(), n - start);
          kernel(start, length, std::span<const double>(no_energy).first(length));
        }
    }
  } // namespace

  IsothermalEquationOfState::IsothermalEquationOfState(std::shared_ptr<const EquationOfState> law_)
    : law(std::move(law_))
  {
    if (!law)
      throw InputError("isothermal: there is no equation of state to hold at constant temperature");
    const double at_rest = law->reference_density();
    double       stiffness, dp_de;
    law->derivatives({&at_rest, 1}, std::span(no_energy).first(1), {&stiffness, 1}, {&dp_de, 1});
    if (!(stiffness > 0.))
      throw InputError("isothermal = true: equation of state '" + law->name() +
                       "' has no pressure without energy; allowed with laws of solids only");
  }

  void
  IsothermalEquationOfState::evaluate(std::span<const double> true_density, std::span<const double>,
                                      std::span<double> pressure, std::span<double> sound_speed_squared) const
  {
    in_blocks(true_density.size(), [&](std::size_t start, std::size_t length, std::span<const double> zeros) {
      const auto p    = pressure.subspan(start, length);
      const auto c2   = sound_speed_squared.subspan(start, length);
      const auto here = true_density.subspan(start, length);

      std::array<double, no_energy.size()> dp_de;
      // c^2 = dP/dgamma: the energy that work adds has no say.
      law->evaluate(here, zeros, p, c2);
      law->derivatives(here, zeros, c2, std::span(dp_de).first(length));
    });
  }

  void
  IsothermalEquationOfState::derivatives(std::span<const double> true_density, std::span<const double>,
                                         std::span<double> dp_ddensity, std::span<double> dp_de) const
  {
    in_blocks(true_density.size(), [&](std::size_t start, std::size_t length, std::span<const double> zeros) {
      law->derivatives(true_density.subspan(start, length), zeros, dp_ddensity.subspan(start, length),
                       dp_de.subspan(start, length));
    });
    std::fill(dp_de.begin(), dp_de.end(), 0.);
  }

  double
  IsothermalEquationOfState::energy_of_pressure(double true_density, double pressure) const
  {
    check_density(true_density);
    double cold, stiffness, at_rest = reference_density(), reference_stiffness, unused;
    evaluate({&true_density, 1}, {}, {&cold, 1}, {&stiffness, 1});
    derivatives({&at_rest, 1}, {}, {&reference_stiffness, 1}, {&unused, 1});
    if (!(std::abs(pressure - cold) <= 1e-12 * at_rest * reference_stiffness))
      {
        std::ostringstream message;
        message << name() << " (isothermal): pressure at density " << true_density << " g/cm^3 is " << cold
                << " Mbar whatever the energy; " << pressure << " Mbar cannot be had";
        throw StateError(message.str());
      }
    return 0.;
  }

  double
  IsothermalEquationOfState::reference_density() const
  {
    return law->reference_density();
  }

  double
  IsothermalEquationOfState::max_density() const
  {
    return law->max_density();
  }

  std::string
  IsothermalEquationOfState::name() const
  {
    return law->name();
  }
} // namespace whipple
