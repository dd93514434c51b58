// SPDX-License-Identifier: LGPL-2.1-or-later
#pragma once

#include <whipple/problem/material_models.h>
#include <whipple/scene/scene.h>

#include <string>
#include <vector>

/// What the list of effects means for the materials of a scene.
namespace whipple::sections
{
  /// Effects must have a model to work with, and must not contradict each other.
  /// @throws InputError one line: the effect and what it needs.
  void
  check_effects(const std::vector<SceneMaterial> &materials, const std::vector<MaterialModels> &models,
                const std::vector<std::string> &effects);

  /// Void fraction that the material's bodies enter with; 0 without a void law.
  double
  initial_void_fraction(const Material &material);

  /// The material with the models of effects that are off left out, and with what effects do to each other: melting
  /// softens.
  Material
  with_effects(const Material &complete, const std::vector<std::string> &effects);
} // namespace whipple::sections
