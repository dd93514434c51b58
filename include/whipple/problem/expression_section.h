// SPDX-License-Identifier: LGPL-2.1-or-later
#pragma once

#include <whipple/exact/exact_solution.h>
#include <whipple/scene/scene.h>
#include <whipple/scene/section.h>

#include <memory>
#include <string>
#include <vector>

/// The keys of a body that give its initial state as expressions.
namespace whipple::sections
{
  void
  declare_expressions(SceneSection &section);

  /// Those of these keys that a scene gives.
  std::vector<std::string>
  given_expressions(const SceneSection &section);

  /// Refuse what a body says twice, as an expression and otherwise; before values in force are filled in.
  template <int dim>
  void
  reject_doubles(const SceneSection &section, const Body<dim> &body);

  /// Give a body, complete with its uniform state, the means of its expressions, for whoever asks for one density,
  /// energy or velocity. Needs the scene's lattice.
  /// @returns the state that they describe; null where there is no expression, and nothing happens
  template <int dim>
  std::shared_ptr<const exact::ExactSolution<dim>>
  read_expressions(const SceneSection &section, const Scene<dim> &scene, Body<dim> &body);
} // namespace whipple::sections
