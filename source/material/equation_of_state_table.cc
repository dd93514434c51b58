// SPDX-License-Identifier: LGPL-2.1-or-later
#include <whipple/error.h>
#include <whipple/material/equation_of_state_table.h>
#include <whipple/material/piecewise_cubic.h>
#include <whipple/material/rising_points.h>
#include <whipple/material/table_field.h>
#include <whipple/material/trial.h>

#include <algorithm>
#include <cmath>
#include <sstream>
#include <utility>

namespace whipple
{
  namespace
  {
    const TableField::Units density_units{{"g/cm^3", 1.}, {"kg/m^3", 1e-3}};
    const TableField::Units energy_units{{"Mbar cm^3/g", 1.}, {"MJ/kg", 0.01}, {"J/kg", 1e-8}, {"erg/g", 1e-12}};
    const TableField::Units pressure_units{{"Mbar", 1.}, {"GPa", 0.01}, {"Pa", 1e-11}, {"dyn/cm^2", 1e-12}};
    const TableField::Units temperature_units{{"K", 1.}, {"eV", 11604.518}};
    const TableField::Units fraction_units{{"1", 1.}};

    // Far beyond what tables hold (the interior of a white dwarf): a wrong unit or a broken file.
    constexpr double largest_density = 1e12, largest_energy = 1e15, largest_pressure = 1e22, largest_temperature = 1e16;

    /// Energies fall along T where branches of a table were joined: real tables by up to 0.06 % of a row's range.
    constexpr double largest_fall_of_energy = 0.01;

    /// Fields over (density, the second axis of the file), rows of a density.
    struct Grid
    {
      std::vector<double> pressure, temperature, melt_fraction, vapour_fraction;
    };

    Grid
    read_grid(const Hdf5File &file, const std::vector<std::size_t> &extent, bool with_temperature)
    {
      Grid             grid;
      const TableField pressure(file, "pressure", pressure_units, extent);
      pressure.require_at_most(largest_pressure);
      grid.pressure = pressure.values();
      if (with_temperature && file.has("temperature"))
        {
          const TableField temperature(file, "temperature", temperature_units, extent);
          temperature.require_positive();
          temperature.require_rising();
          temperature.require_at_most(largest_temperature);
          grid.temperature = temperature.values();
        }
      for (const auto &[name, values] :
           {std::pair{"melt_fraction", &grid.melt_fraction}, std::pair{"vapour_fraction", &grid.vapour_fraction}})
        if (file.has(name))
          {
            const TableField fraction(file, name, fraction_units, extent);
            fraction.require_fraction();
            *values = fraction.values();
          }
      return grid;
    }

    /// Those points of a row over temperature that have energies of their own (rising_points()).
    struct Row
    {
      std::vector<std::size_t> points;
      std::vector<double>      heat; ///< of the points, from 0
    };

    std::vector<Row>
    rows_of(const TableField &energy, std::size_t m)
    {
      std::vector<Row>              rows;
      const std::span<const double> all(energy.values());
      for (std::size_t k = 0; k < all.size(); k += m)
        {
          Row row{rising_points(all.subspan(k, m)), {}};
          if (row.points.size() < 2)
            energy.reject(k, "fewer than two energies of this row rise; must rise with temperature");
          for (const std::size_t j : row.points)
            row.heat.push_back(all[k + j] - all[k + row.points[0]]);
          rows.push_back(std::move(row));
        }
      return rows;
    }

    /// The heat of the row nearest to the reference density, and beyond it the largest of any row.
    std::vector<double>
    common_heat(const EquationOfStateTable &table, const std::vector<Row> &rows)
    {
      std::size_t nearest = 0;
      double      largest = 0;
      for (std::size_t i = 0; i < rows.size(); ++i)
        {
          if (std::abs(table.density[i] - table.reference_density) <
              std::abs(table.density[nearest] - table.reference_density))
            nearest = i;
          largest = std::max(largest, rows[i].heat.back());
        }
      std::vector<double> heat = rows[nearest].heat;
      if (largest > (1. + table_rounding) * heat.back())
        heat.push_back(largest);
      return heat;
    }

    /// A row given at some heats taken at others: by the monotone cubic, or (fractions, that must stay in their range)
    /// by straight lines that end level.
    enum class Between
    {
      cubic,
      line
    };

    void
    append_row(const Row &row, const double *all, Between between, const std::vector<double> &heat,
               std::vector<double> &values)
    {
      std::vector<double> given;
      for (const std::size_t j : row.points)
        given.push_back(all[j]);
      if (between == Between::cubic)
        {
          const PiecewiseCubic cubic(row.heat, given, monotone_slopes(row.heat, given, 3.));
          for (const double h : heat)
            values.push_back(cubic.at(h).value);
        }
      else
        for (const double h : heat)
          {
            const std::size_t j     = find_interval(row.heat, h, 0);
            const double      share = std::clamp((h - row.heat[j]) / (row.heat[j + 1] - row.heat[j]), 0., 1.);
            values.push_back((1. - share) * given[j] + share * given[j + 1]);
          }
    }

    /// From (density, temperature) to (density, heat).
    void
    resample(const std::vector<Row> &rows, const Grid &grid, std::size_t m, EquationOfStateTable &table)
    {
      table.heat = common_heat(table, rows);
      for (std::size_t i = 0; i < rows.size(); ++i)
        {
          append_row(rows[i], &grid.pressure[i * m], Between::cubic, table.heat, table.pressure);
          append_row(rows[i], &grid.temperature[i * m], Between::cubic, table.heat, table.temperature);
          if (!grid.melt_fraction.empty())
            append_row(rows[i], &grid.melt_fraction[i * m], Between::line, table.heat, table.melt_fraction);
          if (!grid.vapour_fraction.empty())
            append_row(rows[i], &grid.vapour_fraction[i * m], Between::line, table.heat, table.vapour_fraction);
        }
    }

    /// In internal units.
    double
    reference_energy(const Hdf5File &file, double unit)
    {
      const double value = file.attribute("reference_energy");
      if (!(std::abs(value) * unit <= largest_energy))
        {
          std::ostringstream text, allowed;
          text << value;
          allowed << "must be an energy of at most " << largest_energy / unit << " in size, in the units of 'energy'";
          throw InputError(file.path(), "attribute reference_energy", text.str(), allowed.str());
        }
      return value * unit;
    }

    void
    read_over_temperature(const Hdf5File &file, EquationOfStateTable &table)
    {
      const std::size_t n = table.density.size();
      const TableField  temperature(file, "temperature", temperature_units, {0});
      temperature.require_rising();
      temperature.require_not_negative();
      temperature.require_at_most(largest_temperature);
      const std::size_t m = temperature.values().size();
      const TableField  energy(file, "energy", energy_units, {n, m});
      energy.require_at_most(largest_energy);
      energy.require_nearly_rising(largest_fall_of_energy);
      const double           reference = reference_energy(file, energy.unit());
      const std::vector<Row> rows      = rows_of(energy, m);
      Grid                   grid      = read_grid(file, {n, m}, false);
      for (std::size_t i = 0; i < n; ++i)
        {
          grid.temperature.insert(grid.temperature.end(), temperature.values().begin(), temperature.values().end());
          table.lowest_energy.push_back(energy.values()[i * m + rows[i].points[0]] - reference);
          table.points_left_out += m - rows[i].points.size();
        }
      resample(rows, grid, m, table);
    }

    void
    read_over_energy(const Hdf5File &file, EquationOfStateTable &table)
    {
      const std::size_t n = table.density.size();
      const TableField  energy(file, "energy", energy_units, {0});
      energy.require_rising();
      energy.require_at_most(largest_energy);
      const double lowest = energy.values().front();
      for (const double e : energy.values())
        table.heat.push_back(e - lowest);
      table.lowest_energy.assign(n, lowest - reference_energy(file, energy.unit()));
      Grid grid             = read_grid(file, {n, energy.values().size()}, true);
      table.pressure        = std::move(grid.pressure);
      table.temperature     = std::move(grid.temperature);
      table.melt_fraction   = std::move(grid.melt_fraction);
      table.vapour_fraction = std::move(grid.vapour_fraction);
    }

    void
    require_two(const std::string &path, const std::string &axis, std::size_t length)
    {
      if (length < 2)
        throw InputError(path, axis + ", extent", std::to_string(length), "must be at least 2");
    }

    EquationOfStateTable
    read(const std::string &path)
    {
      const Hdf5File       file(path);
      EquationOfStateTable table;
      table.path = path;
      const TableField density(file, "density", density_units, {0});
      density.require_positive();
      density.require_rising();
      density.require_at_most(largest_density);
      table.density           = density.values();
      table.reference_density = file.attribute("reference_density") * density.unit();
      require_two(path, "density", table.density.size());
      if (!(table.reference_density >= table.density.front() && table.reference_density <= table.density.back()))
        {
          std::ostringstream value, allowed;
          value << table.reference_density;
          allowed << "must be among the densities of the table, " << table.density.front() << " ... "
                  << table.density.back() << " g/cm^3";
          throw InputError(path, "attribute reference_density", value.str(), allowed.str());
        }
      if (!file.has("energy"))
        throw InputError(path + ": dataset 'energy' is missing");
      if (file.read("energy").extent.size() == 1)
        read_over_energy(file, table);
      else
        read_over_temperature(file, table);
      require_two(path, "energy or temperature", table.heat.size());
      if (file.has("melt_temperature"))
        {
          const TableField melt(file, "melt_temperature", temperature_units, {table.density.size()});
          melt.require_positive();
          table.melt_temperature = melt.values();
        }
      return table;
    }
  } // namespace

  EquationOfStateTable
  read_equation_of_state_table(const std::string &path)
  {
    constexpr int     seconds = 10;
    const std::string failure = failure_of_trial([&] { read(path); }, seconds);
    if (!failure.empty())
      throw InputError(path + ": cannot be read as HDF5: the file is damaged, the HDF5 library ends with " + failure +
                       "; allowed is an HDF5 file");
    return read(path);
  }
} // namespace whipple
