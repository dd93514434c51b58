// SPDX-License-Identifier: LGPL-2.1-or-later
#pragma once

#include <whipple/scene/prm_statements.h>

#include <vector>

namespace whipple
{
  /// Name of the section of variables.
  inline constexpr const char *variables_section = "Variables";

  /// Put the values of a scene's variables where they are used: `$d` or `${d}` in a value stands for the text that
  /// `set d = 0.32 cm` in the section Variables gives, or `set Variables = d = 0.32 cm, gap = 2 cm` in one line. The
  /// last statement counts, so that the command line or a study can change a variable. A variable may use those before
  /// it. The statements that define variables are removed.
  /// @throws InputError for a name that is none (letters, digits and _, no digit first), and for a variable that is not
  ///         defined where it is used, or that the command line defines and nothing uses
  void
  substitute_variables(std::vector<PrmStatement> &statements);
} // namespace whipple
