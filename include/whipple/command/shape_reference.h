// SPDX-License-Identifier: LGPL-2.1-or-later
#pragma once

#include <string>

namespace whipple
{
  /// Every registered shape of bodies with its paragraph and parameters, as Markdown: `whipple help shapes`,
  /// doc/shapes.md.
  std::string
  shape_reference();
} // namespace whipple
