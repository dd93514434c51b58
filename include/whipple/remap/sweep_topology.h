// SPDX-License-Identifier: LGPL-2.1-or-later
#pragma once

#include <whipple/mesh/flat_mesh.h>

#include <array>
#include <vector>

namespace whipple
{
  /// What a sweep along one axis needs to know of the mesh, as arrays without special cases: absent subfaces are
  /// face number `n_faces`, where every face array holds 0; absent neighbours are the cell itself.
  template <int dim>
  struct SweepTopology
  {
    SweepTopology(const FlatMesh<dim> &mesh, int axis);

    int                   axis;
    Index                 n_faces;
    const FlatFaces<dim> *faces;

    /// [subface][cell] faces on the lower and upper side of the cell along the axis.
    std::array<std::vector<Index>, 2> lower, upper;

    /// [subface][cell] cells across them; both entries the same where there is one.
    std::array<std::vector<Index>, 2> below, above;

    /// [cell] central difference over unequal cells: size * slope = weight_below (q - q_below) +
    /// weight_above (q_above - q), exact for parabolas along a line.
    std::vector<double> weight_below, weight_above;

    /// [side of the face][face] which part (by area) of that cell's whole side the subface is.
    std::array<std::vector<double>, 2> part_share;

    /// Faces on a side of the domain.
    std::vector<Index> boundary_faces;

    /// Faces inside the domain where the active region ends.
    std::vector<Index> end_faces;

    /// Sum over the cell's subfaces of an array that holds what passes along + axis: what stays in the cell.
    double
    net(const std::vector<double> &flux, const Index cell) const
    {
      return (flux[lower[0][cell]] + flux[lower[1][cell]]) - (flux[upper[0][cell]] + flux[upper[1][cell]]);
    }
  };
} // namespace whipple
