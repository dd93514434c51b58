// SPDX-License-Identifier: LGPL-2.1-or-later
#pragma once

#include <whipple/scene/scene.h>
#include <whipple/scene/section.h>
#include <whipple/scene/shape_registry.h>

/// The keys of a body that say what it looks like.
namespace whipple::sections
{
  /// Declare the parameters of all kinds of shapes.
  void
  declare_shape(SceneSection &section);

  /// The kind of shape that a body names.
  const ShapeDescription &
  shape_description(const SceneSection &section);

  /// The shape of a body, turned as it says; needs the scene's symmetry and lattice.
  template <int dim>
  Shape<dim>
  read_shape(const SceneSection &section, const Scene<dim> &scene);
} // namespace whipple::sections
