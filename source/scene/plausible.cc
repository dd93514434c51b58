// SPDX-License-Identifier: LGPL-2.1-or-later
#include <whipple/scene/plausible.h>

namespace whipple::plausible
{
  double
  largest(const units::Quantity &quantity)
  {
    constexpr double light = 29979.2458; // cm/us
    struct Limit
    {
      const units::Quantity &quantity;
      double                 largest;
    };
    static constexpr Limit limits[] = {{units::number, 1e6},       {units::length, 1e12},
                                       {units::time, 1e15},        {units::velocity, light},
                                       {units::density, 1e9},      {units::pressure, 1e15},
                                       {units::temperature, 1e12}, {units::specific_energy, light * light}};
    for (const Limit &limit : limits)
      if (limit.quantity.dimension == quantity.dimension)
        return limit.largest;
    return 1e40; // compound ones: powers of them are still numbers
  }

  double
  pressure(const SceneSection &section, const std::string &key, const std::string &part)
  {
    constexpr double largest_tension = 1.; // Mbar: diamond and tungsten break below it
    const double     value           = section.parse(key, part, units::pressure);
    if (!(value >= -largest_tension))
      section.reject(key, "a tension that no matter holds; allowed is a pressure of at least " +
                              units::format(-largest_tension, units::pressure));
    return value;
  }
} // namespace whipple::plausible
