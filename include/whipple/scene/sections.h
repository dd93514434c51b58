// SPDX-License-Identifier: LGPL-2.1-or-later
#pragma once

#include <whipple/scene/scene.h>
#include <whipple/scene/section.h>

#include <array>
#include <string>
#include <vector>

/// The sections of a scene file: for each, the declaration of its entries (with defaults and documentation) and how
/// they become a part of the Scene. Sections that hold named entries (materials, bodies, stages) are declared for the
/// names that their key `List` holds. Every read_ function throws InputError.
namespace whipple::sections
{
  /// Keys of the sides of the domain, ordered 2 * axis + upper.
  inline const std::array<std::string, 4> side_names{{"Left", "Right", "Bottom", "Top"}};

  void
  declare_geometry(SceneParameters &parameters);
  /// Symmetry, lattice origin, boundaries; returns the upper corner of the domain as the file gives it.
  template <int dim>
  Vector<dim>
  read_geometry(SceneParameters &parameters, Scene<dim> &scene);
  /// Mesh maps need moving meshes and a domain that they do not fold; needs the scene's lattice and stages.
  template <int dim>
  void
  check_mesh_map(SceneParameters &parameters, const Scene<dim> &scene);

  void
  declare_mesh(SceneParameters &parameters);
  /// Lattice and mesh control. The domain grows to a whole number of root cells: Geometry/Upper corner is replaced.
  template <int dim>
  void
  read_mesh(SceneParameters &parameters, const Vector<dim> &upper, Scene<dim> &scene);

  void
  declare_effects(SceneParameters &parameters);
  /// Effects, verdicts and the models they leave on, from the list or, if that says auto, from the scene; needs
  /// materials, bodies, stages and lattice.
  template <int dim>
  void
  read_effects(SceneParameters &parameters, Scene<dim> &scene);

  void
  declare_materials(SceneParameters &parameters, const std::vector<std::string> &names);
  /// Materials with all models that the scene names; effects come later.
  std::vector<SceneMaterial>
  read_materials(SceneParameters &parameters);

  void
  declare_bodies(SceneParameters &parameters, const std::vector<std::string> &names);
  /// Bodies with complete initial states; needs the scene's materials.
  template <int dim>
  std::vector<Body<dim>>
  read_bodies(SceneParameters &parameters, const Scene<dim> &scene);
  /// Inside the domain, no two of them overlapping; needs the scene's bodies and lattice.
  template <int dim>
  void
  check_bodies(SceneParameters &parameters, const Scene<dim> &scene);

  /// The ambient state beyond sides that keep it: that of the bodies which touch them; needs the scene's bodies,
  /// materials and lattice.
  /// @throws InputError where no body touches such a side, or bodies of different states do
  template <int dim>
  void
  read_side_media(SceneParameters &parameters, Scene<dim> &scene);

  void
  declare_stages(SceneParameters &parameters, const std::vector<std::string> &names);
  /// Needs the scene's bodies.
  template <int dim>
  std::vector<Stage>
  read_stages(SceneParameters &parameters, const Scene<dim> &scene);

  void
  declare_numerics(SceneParameters &parameters);
  Numerics
  read_numerics(SceneParameters &parameters);

  void
  declare_output(SceneParameters &parameters);
  OutputControl
  read_output(SceneParameters &parameters);

  void
  declare_exact_solution(SceneParameters &parameters);
  /// Null if the scene names none; needs all of the scene but numerics and output.
  template <int dim>
  std::shared_ptr<const exact::ExactSolution<dim>>
  read_exact_solution(SceneParameters &parameters, const Scene<dim> &scene);
  /// Give sides that follow the exact solution its velocity.
  template <int dim>
  void
  drive_sides(SceneParameters &parameters, Scene<dim> &scene);
  /// Bodies that enter with the exact state need an exact solution.
  template <int dim>
  void
  check_initial_states(SceneParameters &parameters, const Scene<dim> &scene);
} // namespace whipple::sections
