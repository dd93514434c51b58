// SPDX-License-Identifier: LGPL-2.1-or-later
#pragma once

#include <map>
#include <string>

namespace whipple
{
  /// Values of an effect's parameters by their keys, internal units.
  using EffectParameters = std::map<std::string, double>;
} // namespace whipple
