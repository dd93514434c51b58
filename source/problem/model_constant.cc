// SPDX-License-Identifier: LGPL-2.1-or-later
#include <whipple/problem/model_constant.h>

#include <cmath>
#include <limits>
#include <stdexcept>

namespace whipple::sections
{
  namespace
  {
    const units::Quantity &
    quantity_of(const ModelConstant &constant)
    {
      if (const units::Quantity *quantity = units::find_quantity(constant.quantity))
        return *quantity;
      throw std::logic_error("model constant '" + constant.key + "' is a '" + constant.quantity +
                             "', which scenes do not know");
    }
  } // namespace

  double
  read_constant(const SceneSection &section, const ModelConstant &constant)
  {
    if (constant.range.infinite && section.text(constant.key) == "infinite")
      return std::numeric_limits<double>::infinity();
    const double value = section.quantity(constant.key, quantity_of(constant));
    if (!constant.range.contains(value))
      section.reject(constant.key, "must be " + constant.range.text());
    return value;
  }

  std::string
  written(const ModelConstant &constant, double value)
  {
    return std::isinf(value) ? "infinite" : units::format(value, quantity_of(constant));
  }
} // namespace whipple::sections
