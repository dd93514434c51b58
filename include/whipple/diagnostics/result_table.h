// SPDX-License-Identifier: LGPL-2.1-or-later
#pragma once

#include <whipple/output/summary.h>

#include <map>
#include <string>

namespace whipple
{
  /// Results of one place under the names they have in summary.json (doc/results.md): quantity -> value.
  using ResultTable = std::map<std::string, summary::Result>;

  /// The place under which what is compared with the scene's exact solution is reported.
  inline constexpr const char *exact_place = "exact solution";
} // namespace whipple
