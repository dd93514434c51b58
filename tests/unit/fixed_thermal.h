// SPDX-License-Identifier: LGPL-2.1-or-later
#pragma once

#include <whipple/material/thermal_model.h>

#include <algorithm>

namespace whipple
{
  /// The energy is the temperature in K; melts from 1000 to 1100 K whatever the density: for numbers by hand.
  class FixedThermal : public ThermalModel
  {
  public:
    void
    evaluate(std::span<const double> density, std::span<const double> energy,
             const ThermalOutput &output) const override
    {
      const auto write = [&](std::span<double> wanted, const auto &f) {
        if (!wanted.empty())
          for (std::size_t i = 0; i < density.size(); ++i)
            wanted[i] = f(energy[i]);
      };
      write(output.temperature, [](double e) { return std::min(e, 1000.) + std::max(e - 1100., 0.); });
      write(output.melt_temperature, [](double) { return 1000.; });
      write(output.melt_fraction, [](double e) { return std::clamp((e - 1000.) / 100., 0., 1.); });
      write(output.vapour_fraction, [](double) { return 0.; });
    }
    double
    specific_heat() const override
    {
      return 1.;
    }
    Transitions
    transitions() const override
    {
      return {1000., 1100., 1e9, 1e9};
    }
    std::string
    name() const override
    {
      return "fixed";
    }
  };
} // namespace whipple
