// SPDX-License-Identifier: LGPL-2.1-or-later
#include <whipple/error.h>
#include <whipple/material/table_field.h>

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
    for (std::size_t k = 1; k < values_.size(); ++k)
      if (k % extent_.back() != 0 && !(values_[k] > values_[k - 1]))
        reject(k, "must be greater than the value before it");
  }

  void
  TableField::require_not_falling() const
  {
    for (std::size_t k = 1; k < values_.size(); ++k)
      if (k % extent_.back() != 0 && !(values_[k] >= values_[k - 1]))
        reject(k, "must not be less than the value before it");
  }

  void
  TableField::require_positive() const
  {
    for (std::size_t k = 0; k < values_.size(); ++k)
      if (!(values_[k] > 0.))
        reject(k, "must be > 0");
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
