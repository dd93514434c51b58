// SPDX-License-Identifier: LGPL-2.1-or-later
#pragma once

#include <hdf5.h>

#include <algorithm>
#include <filesystem>
#include <limits>
#include <string>
#include <vector>

namespace whipple::stability
{
  /// Largest value of a cell field over all field files that a run wrote (scenes with a fields interval).
  /// @param field name as in the file: "pressure", "density"
  inline double
  largest_in_files(const std::string &directory, const std::string &field)
  {
    double largest = -std::numeric_limits<double>::infinity();
    for (const auto &entry : std::filesystem::directory_iterator(directory + "/fields"))
      {
        if (entry.path().extension() != ".h5")
          continue;
        const hid_t file = H5Fopen(entry.path().c_str(), H5F_ACC_RDONLY, H5P_DEFAULT);
        if (file < 0)
          continue;
        if (H5Lexists(file, field.c_str(), H5P_DEFAULT) > 0)
          {
            const hid_t         set   = H5Dopen2(file, field.c_str(), H5P_DEFAULT);
            const hid_t         space = H5Dget_space(set);
            std::vector<double> values(static_cast<std::size_t>(H5Sget_simple_extent_npoints(space)));
            if (!values.empty())
              H5Dread(set, H5T_NATIVE_DOUBLE, H5S_ALL, H5S_ALL, H5P_DEFAULT, values.data());
            for (const double value : values)
              largest = std::max(largest, value);
            H5Sclose(space);
            H5Dclose(set);
          }
        H5Fclose(file);
      }
    return largest;
  }
} // namespace whipple::stability
