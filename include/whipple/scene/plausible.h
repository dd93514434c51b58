// SPDX-License-Identifier: LGPL-2.1-or-later
#pragma once

#include <whipple/scene/section.h>

/// Numbers that can be read and mean nothing: slips of units and of exponents, that would end in not-a-number or never.
namespace whipple::plausible
{
  /// Size of a number, in internal units, far above what scenes hold, from micrometre grains to planets. A velocity
  /// ends at that of light, a specific energy at its square.
  double
  largest(const units::Quantity &quantity);

  /// The pressure in `part` of the value of a key.
  /// @throws InputError if it is a tension beyond the strength of any matter.
  double
  pressure(const SceneSection &section, const std::string &key, const std::string &part);
} // namespace whipple::plausible
