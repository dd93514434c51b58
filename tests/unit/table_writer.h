// SPDX-License-Identifier: LGPL-2.1-or-later
#pragma once

#include <hdf5.h>
#include <unistd.h>

#include <cstdio>
#include <filesystem>
#include <string>
#include <vector>

/// Writes tables of equations of state in the layout of doc/theory/equation_of_state_tables.md, right or wrong.
namespace whipple::table_writer
{
  /// In g/cm^3, K, GPa and MJ/kg. Empty arrays are not written.
  struct Table
  {
    bool                over_energy = false; ///< second is the energy, else the temperature
    std::vector<double> density, second;     ///< axes
    std::vector<double> pressure, energy, temperature, melt_fraction, vapour_fraction; ///< rows of a density
    std::vector<double> melt_temperature;
    double              reference_density = 2.7, reference_energy = 0;
    std::string         pressure_units = "GPa";
    std::string         missing; ///< dataset or attribute that is left out
  };

  /// Name of a file of this process, removed with the object.
  class File
  {
  public:
    explicit File(const std::string &name)
      : path_((std::filesystem::temp_directory_path() / (std::to_string(getpid()) + "_" + name)).string())
    {
    }
    ~File()
    {
      std::remove(path_.c_str());
    }
    const std::string &
    path() const
    {
      return path_;
    }

  private:
    std::string path_;
  };

  inline void
  write_dataset(hid_t file, const Table &table, const std::string &name, const std::vector<double> &values,
                const std::vector<hsize_t> &extent, const std::string &units)
  {
    if (values.empty() || name == table.missing)
      return;
    const hid_t space = H5Screate_simple(static_cast<int>(extent.size()), extent.data(), nullptr);
    const hid_t dataset =
        H5Dcreate2(file, name.c_str(), H5T_NATIVE_DOUBLE, space, H5P_DEFAULT, H5P_DEFAULT, H5P_DEFAULT);
    H5Dwrite(dataset, H5T_NATIVE_DOUBLE, H5S_ALL, H5S_ALL, H5P_DEFAULT, values.data());
    if (!units.empty())
      {
        const hid_t type = H5Tcopy(H5T_C_S1), scalar = H5Screate(H5S_SCALAR);
        H5Tset_size(type, units.size());
        const hid_t attribute = H5Acreate2(dataset, "units", type, scalar, H5P_DEFAULT, H5P_DEFAULT);
        H5Awrite(attribute, type, units.data());
        H5Aclose(attribute);
        H5Sclose(scalar);
        H5Tclose(type);
      }
    H5Dclose(dataset);
    H5Sclose(space);
  }

  inline void
  write_attribute(hid_t file, const Table &table, const std::string &name, double value)
  {
    if (name == table.missing)
      return;
    const hid_t scalar    = H5Screate(H5S_SCALAR);
    const hid_t attribute = H5Acreate2(file, name.c_str(), H5T_NATIVE_DOUBLE, scalar, H5P_DEFAULT, H5P_DEFAULT);
    H5Awrite(attribute, H5T_NATIVE_DOUBLE, &value);
    H5Aclose(attribute);
    H5Sclose(scalar);
  }

  inline void
  write(const std::string &path, const Table &table)
  {
    const hid_t                file = H5Fcreate(path.c_str(), H5F_ACC_TRUNC, H5P_DEFAULT, H5P_DEFAULT);
    const hsize_t              n = table.density.size(), m = table.second.size();
    const std::vector<hsize_t> grid{n, m};
    write_dataset(file, table, "density", table.density, {n}, "g/cm^3");
    if (table.over_energy)
      write_dataset(file, table, "energy", table.second, {m}, "MJ/kg");
    else
      write_dataset(file, table, "energy", table.energy, grid, "MJ/kg");
    if (table.over_energy)
      write_dataset(file, table, "temperature", table.temperature, grid, "K");
    else
      write_dataset(file, table, "temperature", table.second, {m}, "K");
    write_dataset(file, table, "pressure", table.pressure, grid, table.pressure_units);
    write_dataset(file, table, "melt_fraction", table.melt_fraction, grid, "1");
    write_dataset(file, table, "vapour_fraction", table.vapour_fraction, grid, "1");
    write_dataset(file, table, "melt_temperature", table.melt_temperature,
                  {static_cast<hsize_t>(table.melt_temperature.size())}, "K");
    write_attribute(file, table, "reference_density", table.reference_density);
    write_attribute(file, table, "reference_energy", table.reference_energy);
    H5Fclose(file);
  }
} // namespace whipple::table_writer
