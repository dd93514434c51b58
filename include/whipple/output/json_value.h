// SPDX-License-Identifier: LGPL-2.1-or-later
#pragma once

#include <whipple/output/summary.h>

#include <nlohmann/json.hpp>

/// How summaries and studies write values as JSON.
namespace whipple::json
{
  /// Keys in the order they are written: these files are also read by people.
  using Json = nlohmann::ordered_json;

  /// A number; null if it is not finite.
  Json
  value(double number);

  /// A number; null if there is none.
  Json
  value(const std::optional<double> &number);
  Json
  value(const std::optional<long> &number);

  /// A number, a verdict or a list of numbers; null where it does not apply.
  Json
  value(const summary::Result &result);
} // namespace whipple::json
