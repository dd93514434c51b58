// SPDX-License-Identifier: LGPL-2.1-or-later
#pragma once

#include <whipple/hydro/folding.h>
#include <whipple/hydro/node_motion.h>
#include <whipple/mesh/flat_mesh.h>
#include <whipple/state/booking.h>
#include <whipple/state/fields.h>

#include <array>
#include <span>
#include <vector>

namespace whipple
{
  /// Reflecting sides of the domain, ordered 2 * axis + {0 lower, 1 upper}. The axis of symmetry needs no mention.
  template <int dim>
  struct RigidWalls
  {
    std::array<bool, 2 * dim>   there{};
    std::array<double, 2 * dim> position{}; ///< cm
  };

  /// Fragments that were released, over owned cells.
  template <int dim>
  struct Released
  {
    Index                           number = 0; ///< newly made rigid
    std::vector<RigidFragment<dim>> rigid;      ///< that must keep their shape in the next step, ordered by cell
    Booking<dim> booking; ///< kinetic energy of relative motion turned into heat; impulse given to walls that fragments
                          ///< meet (at the axis: radial)
  };

  /// Keep independent fragments from folding: one whose motion over the next dt would bring a corner Jacobian below
  /// `least_jacobian` of the mean, or a corner across the axis of symmetry or through a wall, stops deforming: all its
  /// corners take the velocity of its centre of mass (at the axis and at a wall: without its normal part). Mass, axial
  /// momentum (the walls' share is reported) and total energy are kept: the kinetic energy of the relative motion heats
  /// the fragment. Of cells that share no node with others; those that do are left alone.
  /// @param forced owned cells, in ascending order, that stop deforming in any case, if they share no nodes, and keep
  /// their
  ///        shape in the step (as what is about to go through something does): at the point of folding the forces of
  ///        one step may be enough
  template <int dim>
  Released<dim>
  release_fragments(const FlatMesh<dim> &mesh, const RigidWalls<dim> &walls, State<dim> &state, double dt,
                    std::span<const Index> forced = {}, double least_jacobian = least_jacobian_share);
} // namespace whipple
