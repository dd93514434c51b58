// SPDX-License-Identifier: LGPL-2.1-or-later
#pragma once

#include <whipple/mesh/flat_mesh.h>
#include <whipple/problem/material_models.h>
#include <whipple/scene/scene.h>
#include <whipple/state/fields.h>

#include <vector>

namespace whipple
{
  /// The fields that the scene's effects ask for, and where to find them. An effect that is off registers
  /// nothing: no memory, no remap, no pass.
  struct FieldLayout
  {
    std::vector<FieldDescription> fields;
    std::vector<Material>         materials; ///< models by material slot
    std::vector<std::string>      material_names;
    std::vector<Index>            body_material; ///< material slot of each body of the scene
    std::vector<int>              body_tag;      ///< field of each body's mass fraction, -1: what the other tags leave

    /// From the scene: what its effects register (effect/effect.h); the void fraction is a member of MaterialState, not
    /// in the list; "body tags" adds one mass fraction for every body but the last of each material.
    template <int dim>
    FieldLayout(const Scene<dim> &scene, const std::vector<MaterialModels> &models);
    FieldLayout() = default;

    /// The same for a stage: with its void growth coefficient, if it has one of its own.
    FieldLayout
    of_stage(const Stage &stage) const;

    /// Whether the bodies of the scene can be told apart in the state.
    bool bodies_separable = false;

    /// A state without material on a mesh, every array allocated; positions undeformed.
    template <int dim>
    State<dim>
    allocate(const FlatMesh<dim> &mesh) const;

    /// Arrays of a state that an exchange of the cells' contents must bring into the halo.
    template <int dim>
    std::vector<std::vector<double> *>
    cell_arrays(State<dim> &state) const;
    template <int dim>
    std::vector<const std::vector<double> *>
    cell_arrays(const State<dim> &state) const;
  };
} // namespace whipple
