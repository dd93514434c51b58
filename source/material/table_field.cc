// SPDX-License-Identifier: LGPL-2.1-or-later
#include <whipple/error.h>
#include <whipple/material/table_field.h>

#include <algorithm>
#include <cmath>
#include <sstream>
#include <utility>

namespace whipple
{
  namespace
  {
    std::string
    text(const std::vector<std::size_t> &extent)
    {
      std::string result;
      for (const std::size_t e : extent)
        result += (result.empty() ? "" : " x ") + (e == 0 ? std::string("any") : std::to_string(e));
      return result;
    }

    bool
    fits(const std::vector<std::size_t> &extent, const std::vector<std::size_t> &wanted)
    {
      if (extent.size() != wanted.size())
        return false;
      for (std::size_t k = 0; k < extent.size(); ++k)
        if (wanted[k] != 0 && extent[k] != wanted[k])
          return false;
      return true;
    }
  } // namespace

  TableField::TableField(const Hdf5File &file, const std::string &dataset, const Units &units,
                         const std::vector<std::size_t> &extent)
    : path_(file.path())
    , dataset_(dataset)
  {
    Hdf5File::Dataset data = file.read(dataset);
    extent_                = std::move(data.extent);
    values_                = std::move(data.values);
    unit_name_             = std::move(data.units);

    const auto unit = units.find(unit_name_);
    if (unit == units.end())
      {
        std::string names;
        for (const auto &[name, factor] : units)
          names += (names.empty() ? "" : " | ") + name;
        throw InputError(path_, dataset_ + ", attribute units", unit_name_, "must be " + names);
      }
    unit_ = unit->second;
    if (!fits(extent_, extent))
      throw InputError(path_, dataset_ + ", extent", text(extent_), "must be " + text(extent));
    for (std::size_t k = 0; k < values_.size(); ++k)
      {
        values_[k] *= unit_;
        if (!std::isfinite(values_[k]))
          reject(k, "must be finite: the table has a hole");
      }
  }

  void
  TableField::require_rising() const
  {
    // closer neighbours have no slope between them that means anything
    constexpr double rounding = 1e-12;
    for (std::size_t k = 1; k < values_.size(); ++k)
      {
        const double before = values_[k - 1], size = std::max(std::abs(values_[k]), std::abs(before));
        if (k % extent_.back() != 0 && !(values_[k] > before + rounding * size))
          reject(k, "must be greater than the value before it");
      }
  }

  void
  TableField::require_nearly_rising(double share) const
  {
    const std::size_t m = extent_.back();
    for (std::size_t row = 0; row < values_.size(); row += m)
      {
        const auto [low, high] = std::minmax_element(values_.begin() + row, values_.begin() + row + m);
        double largest         = values_[row];
        for (std::size_t k = row; k < row + m; ++k)
          {
            largest = std::max(largest, values_[k]);
            if (largest - values_[k] > share * (*high - *low))
              {
                std::ostringstream allowed;
                allowed << "must not lie below a value before it in the row (" << largest / unit_ << ") by more than "
                        << 100. * share << " % of the row's range";
                reject(k, allowed.str());
              }
          }
      }
  }

  void
  TableField::require_positive() const
  {
    for (std::size_t k = 0; k < values_.size(); ++k)
      if (!(values_[k] > 0.))
        reject(k, "must be > 0");
  }

  void
  TableField::require_not_negative() const
  {
    for (std::size_t k = 0; k < values_.size(); ++k)
      if (!(values_[k] >= 0.))
        reject(k, "must be >= 0");
  }

  void
  TableField::require_at_most(double largest) const
  {
    for (std::size_t k = 0; k < values_.size(); ++k)
      if (!(std::abs(values_[k]) <= largest))
        {
          std::ostringstream allowed;
          allowed << "must be at most " << largest / unit_ << " " << unit_name_ << " in size";
          reject(k, allowed.str());
        }
  }

  void
  TableField::require_fraction() const
  {
    for (std::size_t k = 0; k < values_.size(); ++k)
      if (!(values_[k] >= 0. && values_[k] <= 1.))
        reject(k, "must be in 0 ... 1");
  }

  void
  TableField::reject(std::size_t k, const std::string &allowed) const
  {
    std::string index = std::to_string(k % extent_.back());
    if (extent_.size() > 1)
      index = std::to_string(k / extent_.back()) + ", " + index;
    std::ostringstream value;
    value.precision(10);
    value << values_[k] / unit_ << " " << unit_name_;
    throw InputError(path_, dataset_ + "[" + index + "]", value.str(), allowed);
  }
} // namespace whipple
