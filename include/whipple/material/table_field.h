// SPDX-License-Identifier: LGPL-2.1-or-later
#pragma once

#include <whipple/material/hdf5_file.h>

#include <map>

namespace whipple
{
  /// One dataset of a table, in internal units, that can say what is wrong with it. Each check throws InputError (one
  /// line: file, dataset, index, value in the units of the file, what is allowed).
  class TableField
  {
  public:
    /// Names of units that are understood, and how much of the internal unit each is.
    using Units = std::map<std::string, double>;

    /// @throws InputError if the dataset is missing, its units are not among those, its extent is another (0: any), or
    /// it holds what is not a number.
    TableField(const Hdf5File &file, const std::string &dataset, const Units &units,
               const std::vector<std::size_t> &extent);

    const std::vector<double> &
    values() const
    {
      return values_;
    }

    /// Strictly, along the last index.
    void
    require_rising() const;

    /// The same, but neighbours may be equal.
    void
    require_not_falling() const;

    void
    require_positive() const;

    /// In 0 ... 1.
    void
    require_fraction() const;

    /// How much of the internal unit the unit of the file is.
    double
    unit() const
    {
      return unit_;
    }

  private:
    /// @throws InputError for values_[k].
    [[noreturn]] void
    reject(std::size_t k, const std::string &allowed) const;

    std::string              path_, dataset_, unit_name_;
    std::vector<std::size_t> extent_;
    std::vector<double>      values_;
    double                   unit_;
  };
} // namespace whipple
