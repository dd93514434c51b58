// SPDX-License-Identifier: LGPL-2.1-or-later
#pragma once

#include <whipple/exact/exact_solution.h>
#include <whipple/problem/field_layout.h>
#include <whipple/problem/material_models.h>
#include <whipple/scene/prm_statements.h>
#include <whipple/scene/scene.h>

#include <memory>
#include <string>
#include <vector>

namespace whipple
{
  /// What a run works with: a scene and all that is built from it.
  template <int dim>
  struct Problem
  {
    Scene<dim>                  scene;
    std::vector<MaterialModels> materials; ///< of Scene::materials
    /// Density, energy and velocity of each body where expressions give them; else null.
    std::vector<std::shared_ptr<const exact::ExactSolution<dim>>> body_field;
    std::shared_ptr<const exact::ExactSolution<dim>> exact; ///< what errors are measured against; null: nothing
    FieldLayout                                      layout;

    /// The solution that a body starts from; null if it is uniform, or if there is none.
    const exact::ExactSolution<dim> *
    initial_solution(std::size_t body) const
    {
      if (scene.bodies[body].is_uniform())
        return nullptr;
      return body_field[body] ? body_field[body].get() : exact.get();
    }
  };

  /// Read a scene file, apply overrides ("Section/Sub/Name = value", the last one wins), build the models, check
  /// everything. A section Study (scene/study_section.h) must be well formed and is left out.
  /// @throws InputError one line naming file (or option), key, value and what is allowed.
  template <int dim>
  Problem<dim>
  read_problem(const std::string &file, const std::vector<std::string> &overrides = {});

  /// The same with overrides that know where they come from, so that messages lead there.
  template <int dim>
  Problem<dim>
  read_varied_problem(const std::string &file, const std::vector<PrmStatement> &overrides);

  /// Write Scene::effective_parameters to a file.
  /// @throws Error if it cannot be written.
  template <int dim>
  void
  write_effective_parameters(const Scene<dim> &scene, const std::string &path);
} // namespace whipple
