// SPDX-License-Identifier: LGPL-2.1-or-later
#pragma once

#include <cstddef>
#include <cstdint>
#include <string>
#include <vector>

namespace whipple
{
  /// An HDF5 file of numbers with units, opened to be read, by each rank for itself.
  class Hdf5File
  {
  public:
    /// @throws InputError if there is no such file or it is not HDF5.
    explicit Hdf5File(const std::string &path);
    ~Hdf5File();
    Hdf5File(const Hdf5File &) = delete;
    Hdf5File &
    operator=(const Hdf5File &) = delete;

    const std::string &
    path() const
    {
      return path_;
    }

    struct Dataset
    {
      std::vector<std::size_t> extent; ///< of each index
      std::vector<double>      values; ///< last index fastest
      std::string              units;  ///< its attribute "units"
    };

    bool
    has(const std::string &dataset) const;

    /// @throws InputError if it is missing, no array of numbers, or has no attribute "units".
    Dataset
    read(const std::string &dataset) const;

    /// A number among the attributes of the file.
    /// @throws InputError if it is missing or no number.
    double
    attribute(const std::string &name) const;

  private:
    std::string  path_;
    std::int64_t file_; ///< HDF5's identifier
  };
} // namespace whipple
