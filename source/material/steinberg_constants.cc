// SPDX-License-Identifier: LGPL-2.1-or-later
#include <whipple/error.h>
#include <whipple/material/steinberg_constants.h>

namespace whipple
{
  namespace
  {
    constexpr double GPa = 0.01; // in Mbar

    // Y_max, beta, n, A, B, a: [Steinberg1996], as typed in the material files of [Uintah].
    std::vector<SteinbergConstants>
    make_table()
    {
      return {
          {"aluminium 1100-O", 0.48 * GPa, 400., 0.27, 6.52, 6.16e-4, 1.5, ""},
          {"aluminium 2024-T4", 0.76 * GPa, 310., 0.185, 6.52, 6.16e-4, 1.5, ""},
          {"aluminium 6061-T6", 0.68 * GPa, 125., 0.10, 6.52, 6.16e-4, 1.5, ""},
          {"aluminium 7075-T6", 0.81 * GPa, 965., 0.1, 6.52, 6.16e-4, 1.7, ""},
          {"beryllium S-200", 1.31 * GPa, 26., 0.78, 1.54, 2.58e-4, 1.0,
           "the melting block of the Uintah file holds the values of aluminium: a is that of its equation of state"},
          {"cadmium", 0.60 * GPa, 40., 0.75, 8.75, 14.6e-4, 1.95, ""},
          {"copper OFHC", 0.64 * GPa, 36., 0.45, 2.83, 3.77e-4, 1.5, ""},
          {"lead", 0.10 * GPa, 110., 0.52, 11.63, 1.16e-3, 2.2, ""},
          {"stainless steel 304", 2.5 * GPa, 43., 0.35, 2.6, 4.5e-4, 1.4, ""},
          {"tantalum", 1.10 * GPa, 22., 0.283, 1.45, 1.30e-4, 1.3, ""},
          {"zinc", 0.92 * GPa, 100., 0.2, 5.95, 7.60e-4, 1.7, ""},
      };
    }
  } // namespace

  const std::vector<SteinbergConstants> &
  steinberg_table()
  {
    static const std::vector<SteinbergConstants> table = make_table();
    return table;
  }

  const SteinbergConstants &
  steinberg_constants(const std::string &material)
  {
    for (const SteinbergConstants &constants : steinberg_table())
      if (constants.material == material)
        return constants;
    throw InputError("Steinberg gives no constants for '" + material + "'");
  }
} // namespace whipple
