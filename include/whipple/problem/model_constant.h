// SPDX-License-Identifier: LGPL-2.1-or-later
#pragma once

#include <whipple/material/model_description.h>
#include <whipple/scene/section.h>

#include <string>

/// Constants of models and parameters of effects as entries of a scene.
namespace whipple::sections
{
  /// Value of a constant that a section gives, in internal units.
  /// @throws InputError if it is no number with a unit of the constant's quantity, or out of its range
  double
  read_constant(const SceneSection &section, const ModelConstant &constant);

  /// The value as a scene gives it; "infinite" for infinity.
  std::string
  written(const ModelConstant &constant, double value);
} // namespace whipple::sections
