// SPDX-License-Identifier: LGPL-2.1-or-later
#pragma once

#include <string>
#include <vector>

namespace whipple
{
  /// A tabulated equation of state over true density and heat, the specific energy above that of the lowest row at the
  /// same density; cm, g, us, Mbar, K. Arrays over both hold the value of (density_i, heat_j) at [i * heat.size() + j];
  /// those that the file does not give are empty. Layout of the files: doc/theory/equation_of_state_tables.md.
  struct EquationOfStateTable
  {
    std::string         path;
    double              reference_density = 0; ///< gamma0
    std::vector<double> density;               ///< strictly ascending, > 0
    std::vector<double> heat;                  ///< strictly ascending, from 0
    std::vector<double> lowest_energy;         ///< e at heat 0, of each density, counted from the reference energy
    std::vector<double> pressure;              ///< of any sign and direction
    std::vector<double> temperature;           ///< rises with heat
    std::vector<double> melt_fraction;         ///< in 0 ... 1
    std::vector<double> vapour_fraction;       ///< in 0 ... 1
    std::vector<double> melt_temperature;      ///< of each density
    std::size_t         points_left_out = 0;   ///< of the file: their energies do not rise with temperature
  };

  /// Read a file over (density, energy) as it is; one over (density, temperature) is resampled row by row with monotone
  /// cubics, pressure and temperature over the heat of each density, from those points of the row whose energies rise
  /// (rising_points()).
  /// @throws InputError (one line: file, dataset, index, value, what is allowed) for a file that is not such a table.
  EquationOfStateTable
  read_equation_of_state_table(const std::string &path);
} // namespace whipple
