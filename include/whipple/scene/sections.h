// SPDX-License-Identifier: LGPL-2.1-or-later
#pragma once

#include <whipple/scene/scene.h>
#include <whipple/scene/section.h>

#include <array>
#include <string>
#include <vector>

/// The sections of a scene file: for each, the declaration of its entries (with defaults and documentation) and how
/// they become a part of the Scene. Sections that hold named entries (materials, bodies, stages) are declared for the
/// names that their key `List` holds. Every read_ function throws InputError. Sections that models are built from:
/// problem/problem_sections.h.
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

  /// Move bodies that shall touch another (`Touching = bumper`) along axis 1 to where they meet it: coming along axis
  /// 1, or against it if their velocity says so. Their position is set; needs the lattice.
  template <int dim>
  void
  place_touching_bodies(SceneParameters &parameters, const Scene<dim> &scene);

  /// Inside the domain, no two of them overlapping; needs the scene's bodies and lattice.
  template <int dim>
  void
  check_bodies(SceneParameters &parameters, const Scene<dim> &scene);

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

} // namespace whipple::sections
