// SPDX-License-Identifier: LGPL-2.1-or-later
#pragma once

#include <whipple/mesh/flat_mesh.h>
#include <whipple/state/fields.h>

namespace whipple
{
  /// What releasing fragments did, over owned cells.
  struct ReleaseReport
  {
    Index  released     = 0; ///< fragments newly made rigid
    double kinetic_loss = 0; ///< Mbar cm^3 of relative motion turned into heat
  };

  /// Keep independent fragments from folding: one whose motion over the next dt would bring a corner Jacobian below
  /// `least_jacobian` of the mean, or a corner across the axis of symmetry, stops deforming: all its corners
  /// take the velocity of its centre of mass (at the axis: without radial part). Mass, axial momentum and
  /// total energy are kept: the kinetic energy of the relative motion heats the fragment.
  /// Of cells that share no node with others; those that do are left alone.
  template <int dim>
  ReleaseReport
  release_fragments(const FlatMesh<dim> &mesh, State<dim> &state, double dt, double least_jacobian = 0.1);
} // namespace whipple
