// SPDX-License-Identifier: LGPL-2.1-or-later
#pragma once

#include <whipple/problem/problem.h>
#include <whipple/scene/section.h>

#include <string>
#include <vector>

/// The sections of a scene file that become models, as scene/sections.h has the others: what they say goes into
/// Problem::scene, what is built from it beside it. Every read_ function throws InputError.
namespace whipple::sections
{
  void
  declare_effects(SceneParameters &parameters);
  /// Effects, verdicts and the models they leave on, from the list or, if that says auto, from the scene; needs
  /// materials, bodies, stages and lattice.
  template <int dim>
  void
  read_effects(SceneParameters &parameters, Problem<dim> &problem);

  void
  declare_materials(SceneParameters &parameters, const std::vector<std::string> &names);
  /// Materials with all models that the scene names; effects come later.
  template <int dim>
  void
  read_materials(SceneParameters &parameters, Problem<dim> &problem);

  void
  declare_bodies(SceneParameters &parameters, const std::vector<std::string> &names);
  /// Bodies with complete initial states; needs the materials.
  template <int dim>
  void
  read_bodies(SceneParameters &parameters, Problem<dim> &problem);

  /// The ambient state beyond sides that keep it: that of the bodies which touch them; needs the scene's bodies,
  /// materials and lattice.
  /// @throws InputError where no body touches such a side, or bodies of different states do
  template <int dim>
  void
  read_side_media(SceneParameters &parameters, Problem<dim> &problem);

  void
  declare_exact_solution(SceneParameters &parameters);
  /// Stays null if the scene names none; needs all of the scene but numerics and output.
  template <int dim>
  void
  read_exact_solution(SceneParameters &parameters, Problem<dim> &problem);
  /// Give sides that follow the exact solution its velocity.
  template <int dim>
  void
  drive_sides(SceneParameters &parameters, Problem<dim> &problem);
  /// Bodies that enter with the exact state need an exact solution.
  template <int dim>
  void
  check_initial_states(SceneParameters &parameters, const Problem<dim> &problem);
} // namespace whipple::sections
