// SPDX-License-Identifier: LGPL-2.1-or-later
#include <whipple/output/json_value.h>

#include <cmath>

namespace whipple::json
{
  namespace
  {
    struct ResultValue
    {
      Json
      operator()(std::monostate) const
      {
        return nullptr;
      }
      Json
      operator()(double number) const
      {
        return value(number);
      }
      Json
      operator()(bool verdict) const
      {
        return verdict;
      }
      Json
      operator()(const std::string &text) const
      {
        return text;
      }
      Json
      operator()(const std::vector<double> &numbers) const
      {
        Json list = Json::array();
        for (const double number : numbers)
          list.push_back(value(number));
        return list;
      }
    };
  } // namespace

  Json
  value(double number)
  {
    return std::isfinite(number) ? Json(number) : Json(nullptr);
  }

  Json
  value(const std::optional<double> &number)
  {
    return number ? value(*number) : Json(nullptr);
  }

  Json
  value(const std::optional<long> &number)
  {
    return number ? Json(*number) : Json(nullptr);
  }

  Json
  value(const summary::Result &result)
  {
    return std::visit(ResultValue{}, result);
  }
} // namespace whipple::json
