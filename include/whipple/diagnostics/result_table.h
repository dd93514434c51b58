// SPDX-License-Identifier: LGPL-2.1-or-later
#pragma once

#include <whipple/output/summary.h>

#include <map>
#include <optional>
#include <string>
#include <variant>

namespace whipple
{
  /// Results of one place under the names they have in summary.json (doc/results.md): quantity -> value.
  using ResultTable = std::map<std::string, summary::Result>;

  /// A result that is a number; nothing if it is none, or is not there.
  inline std::optional<double>
  number_in(const ResultTable &table, const std::string &quantity)
  {
    const auto found = table.find(quantity);
    if (found == table.end())
      return std::nullopt;
    const double *const number = std::get_if<double>(&found->second);
    return number ? std::optional<double>(*number) : std::nullopt;
  }

  /// The place under which what is compared with the scene's exact solution is reported.
  inline constexpr const char *exact_place = "exact solution";
} // namespace whipple
