// SPDX-License-Identifier: LGPL-2.1-or-later
#include <whipple/error.h>
#include <whipple/material/parameter_check.h>

#include <cmath>
#include <sstream>

namespace whipple
{
  namespace
  {
    void
    require(bool holds, const std::string &model, const std::string &quantity, double value, const std::string &unit,
            const std::string &allowed)
    {
      if (holds)
        return;
      std::ostringstream message;
      message << model << ": " << quantity << " = " << value << (unit.empty() ? "" : " ") << unit << ": must be "
              << allowed;
      throw InputError(message.str());
    }
  } // namespace

  void
  require_positive(const std::string &model, const std::string &quantity, double value, const std::string &unit)
  {
    require(std::isfinite(value) && value > 0., model, quantity, value, unit, "> 0");
  }

  void
  require_not_negative(const std::string &model, const std::string &quantity, double value, const std::string &unit)
  {
    require(std::isfinite(value) && value >= 0., model, quantity, value, unit, ">= 0");
  }

  void
  require_greater(const std::string &model, const std::string &quantity, double value, double bound,
                  const std::string &unit)
  {
    std::ostringstream allowed;
    allowed << "> " << bound;
    require(std::isfinite(value) && value > bound, model, quantity, value, unit, allowed.str());
  }
} // namespace whipple
