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

    /// Strictly, along the last index, by more than the rounding of a double.
    void
    require_rising() const;

    /// Along the last index it may be level, and fall by at most `share` of the range of the row.
    void
    require_nearly_rising(double share) const;

    void
    require_positive() const;

    void
    require_not_negative() const;

    /// In size, in internal units.
    void
    require_at_most(double largest) const;

    /// In 0 ... 1.
    void
    require_fraction() const;

    /// How much of the internal unit the unit of the file is.
    double
    unit() const
    {
      return unit_;
    }

    /// @throws InputError for values()[k].
    [[noreturn]] void
    reject(std::size_t k, const std::string &allowed) const;

  private:
    std::string              path_, dataset_, unit_name_;
    std::vector<std::size_t> extent_;
    std::vector<double>      values_;
    double                   unit_;
  };
} // namespace whipple
