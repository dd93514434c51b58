// SPDX-License-Identifier: LGPL-2.1-or-later
#include <whipple/material/johnson_cook_constants.h>

namespace whipple
{
  namespace
  {
    constexpr double MPa = 1e-5; // in Mbar

    constexpr const char *uintah = "G. R. Johnson and W. H. Cook (1983, 1985), as typed in the Uintah material files";
    constexpr const char *johnson_cook = "G. R. Johnson and W. H. Cook (1983, 1985)";

    std::vector<JohnsonCookConstants>
    make_table()
    {
      using Damage = std::array<double, 5>;
      return {
          {"aluminium 2024-T4", 265. * MPa, 426. * MPa, 0.34, 0.015, 1.0, 775., Damage{0.13, 0.13, -1.5, 0.011, 0.},
           johnson_cook, "of the temper T351, all from memory"},
          {"aluminium 6061-T6", 324. * MPa, 114. * MPa, 0.42, 0.002, 1.34, 925., Damage{-0.77, 1.45, -0.47, 0., 1.60},
           uintah, "no ductility is left where tension is above 1.35 times the equivalent stress"},
          {"aluminium 7075-T6", 546. * MPa, 678. * MPa, 0.71, 0.024, 1.56, 893., std::nullopt, johnson_cook,
           "all from memory"},
          {"copper OFHC", 90. * MPa, 292. * MPa, 0.31, 0.025, 1.09, 1356., Damage{0.54, 4.89, -3.03, 0.014, 1.12},
           uintah, ""},
          {"iron Armco", 175. * MPa, 380. * MPa, 0.32, 0.060, 0.55, 1811., Damage{-2.20, 5.43, -0.47, 0.016, 0.63},
           uintah, "thermal exponent 0.55 is the usual value, the Uintah file has 1.44; melt temperature from memory"},
          {"steel 4340", 792. * MPa, 510. * MPa, 0.26, 0.014, 1.03, 1793., Damage{0.05, 3.44, -2.12, 0.002, 0.61},
           uintah, ""},
          {"tool steel S-7", 1539. * MPa, 477. * MPa, 0.18, 0.012, 1.0, 1763., std::nullopt, uintah,
           "melt temperature from memory"},
          {"tungsten alloy", 1507. * MPa, 177. * MPa, 0.12, 0.016, 1.0, 1723., std::nullopt, uintah,
           "melt temperature from memory"},
      };
    }
  } // namespace

  const std::vector<JohnsonCookConstants> &
  johnson_cook_table()
  {
    static const std::vector<JohnsonCookConstants> table = make_table();
    return table;
  }
} // namespace whipple
