// SPDX-License-Identifier: LGPL-2.1-or-later
#pragma once

#include <whipple/material/material.h>
#include <whipple/material/material_request.h>
#include <whipple/material/model_description.h>

#include <optional>
#include <string>
#include <vector>

namespace whipple
{
  /// Kinds of models a material has one of, or none.
  struct ModelFamily
  {
    std::string key;                       ///< in scenes, "Equation of state"
    std::string MaterialRequest::*choice;  ///< where a request names the model
    std::string                   effect;  ///< that switches it on, "strength"; empty: needs none
    std::string                   absence; ///< what "none" means; empty: there must be one
    std::vector<ModelDescription> models;  ///< all there are, alphabetically
  };

  /// All families, in the order in which a material's models are made.
  const std::vector<ModelFamily> &
  model_families();

  /// The description of the model that a request chose of a family; null for none.
  /// @throws InputError that lists the names there are.
  const ModelDescription *
  chosen_model(const ModelFamily &family, const MaterialRequest &request);

  /// Every constant that any model has, each key once, in the order of model_families().
  std::vector<ModelConstant>
  all_model_constants();

  /// What the sources of a model, then the library, give for a constant of a library material; empty without one.
  std::optional<double>
  published_constant(const ModelDescription &model, const std::string &material, const std::string &key);

  /// The material a request describes, ready to run.
  /// @throws InputError (one line: which constant, its value, what is allowed; no file name, the caller knows
  /// it) for an unknown name or model, a constant that is missing, impossible, or of no use to the models chosen, or
  /// models that contradict each other.
  Material
  make_material(const MaterialRequest &request);
} // namespace whipple
