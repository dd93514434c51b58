// SPDX-License-Identifier: LGPL-2.1-or-later
#pragma once

#include <whipple/hydro/fragment_release.h>
#include <whipple/mesh/boundary.h>
#include <whipple/mesh/cell_geometry.h>
#include <whipple/mesh/flat_mesh.h>
#include <whipple/state/derived.h>
#include <whipple/state/fields.h>

#include <cstdint>
#include <vector>

/// Fragments that carry no stress fly ballistically (doc/theory/stages.md, "Free flight").
namespace whipple
{
  /// Void fraction above which fragments may fly freely: voids have joined up, so no effect finds anything to do in
  /// them (the effect "fragment size" has set its size).
  inline constexpr double free_void_fraction = 0.3;

  /// Smallest volume, cm^3, of a cell whose corners fly straight from x [cm] with u [cm/us] for the time `dt`.
  double
  least_volume(Symmetry symmetry, const CornerVectors<2> &x, const CornerVectors<2> &u, double dt);

  /// Whether such a cell has at all times in it no corner Jacobian below the least share of their mean.
  bool
  keeps_shape(const CornerVectors<2> &x, const CornerVectors<2> &u, double dt);

  /// Rubble carries no shear: no shear modulus and no yield stress in cells of their own nodes whose material holds
  /// more void than this.
  void
  soften_rubble(const FlatMesh<2> &mesh, const State<2> &state, double void_fraction, Derived &derived);

  /// Which owned cells need no step for the time `dt`, a flag each: all nodes are their own; every material holds more
  /// void than free_void_fraction all the time, and next to no stress (|P| <= 1e-4 rho c^2); no corner folds, crosses
  /// the axis or goes through a wall; and no node lies on a side that loads it.
  /// @param derived of this state
  std::vector<std::uint8_t>
  flying_cells(const FlatMesh<2> &mesh, const State<2> &state, const Derived &derived, const RigidWalls<2> &walls,
               const Boundaries<2> &boundaries, double dt);

  /// Move all cells with their nodes' velocities: true density, energies and fields stay, the voids take up the change
  /// of volume. What little deviatoric stress there is goes. Time is not advanced.
  void
  fly(const FlatMesh<2> &mesh, double dt, State<2> &state);
} // namespace whipple
