// SPDX-License-Identifier: LGPL-2.1-or-later
#pragma once

#include <whipple/scene/scene.h>
#include <whipple/scene/section.h>

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

  /// Give a body, complete with its uniform state, the state of its expressions: field, and their means for whoever
  /// asks for one density, energy or velocity. Nothing happens where there is no expression. Needs the scene's lattice.
  template <int dim>
  void
  read_expressions(const SceneSection &section, const Scene<dim> &scene, Body<dim> &body);
} // namespace whipple::sections
