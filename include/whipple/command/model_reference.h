// SPDX-License-Identifier: LGPL-2.1-or-later
#pragma once

#include <string>

/// What the registered effects and models say of themselves.
namespace whipple::model_reference
{
  /// Effects, then the models of each family with their one-line summaries: `whipple help effects`.
  std::string
  overview();

  /// Every effect and every model with its paragraph, constants, units, ranges, defaults, sources and the materials it
  /// has published constants for, as Markdown: `whipple help models`, doc/models.md.
  std::string
  markdown();
} // namespace whipple::model_reference
