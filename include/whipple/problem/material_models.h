// SPDX-License-Identifier: LGPL-2.1-or-later
#pragma once

#include <whipple/material/material.h>

namespace whipple
{
  /// The models of one material of a scene.
  struct MaterialModels
  {
    Material complete; ///< all that the scene names, whatever its effects
    Material model;    ///< those that the effects leave on: what runs. Without the effect "strength" model.strength is
                       ///< null, without "voids" model.void_law
  };
} // namespace whipple
