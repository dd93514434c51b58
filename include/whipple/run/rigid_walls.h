// SPDX-License-Identifier: LGPL-2.1-or-later
#pragma once

#include <whipple/hydro/fragment_release.h>
#include <whipple/scene/scene.h>

namespace whipple
{
  /// The reflecting sides, where they are planes of the lattice.
  template <int dim>
  RigidWalls<dim>
  rigid_walls(const Scene<dim> &scene)
  {
    RigidWalls<dim> walls;
    for (int side = 0; side < 2 * dim && scene.mesh_map == MeshMap::identity; ++side)
      {
        walls.there[side]    = scene.boundaries[side].kind == BoundaryKind::reflecting;
        walls.position[side] = side % 2 ? scene.upper_corner()[side / 2] : scene.lattice.origin[side / 2];
      }
    return walls;
  }
} // namespace whipple
