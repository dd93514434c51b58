// SPDX-License-Identifier: LGPL-2.1-or-later
#pragma once

#include <whipple/exact/exact_solution.h>
#include <whipple/mesh/cell_geometry.h>

#include <vector>

namespace whipple
{
  /// A point of a cell and the true volume it stands for.
  template <int dim>
  struct VolumePoint
  {
    Vector<dim> x{};        ///< cm
    double      volume = 0; ///< cm^3
  };

  /// Points that integrate an exact solution over a straight-edged cell. Where it is smooth there, Gauss' rule with
  /// 4 x 4 points. Where breaks of a profile pass through, 16 lines across them, each cut at the breaks, with Gauss'
  /// rule on every piece. Where a solution that is no profile has material at some corners only, 16 x 16 midpoints;
  /// where it looks like jumping otherwise, Gauss' rule on quarters of quarters, down to a 16th of the cell's edge.
  template <int dim>
  std::vector<VolumePoint<dim>>
  volume_points(const exact::ExactSolution<dim> &solution, Symmetry symmetry, const CornerVectors<2> &cell,
                double time);

  /// Means of an exact solution over volume points; what it does not give at one of them is not_given.
  template <int dim>
  struct ExactMeans
  {
    double      density  = exact::not_given;                    ///< by volume, g/cm^3; where there is none counts as 0
    double      pressure = exact::not_given;                    ///< by volume, Mbar; 0 where the density is
    double      energy   = exact::not_given;                    ///< by mass, Mbar cm^3/g
    Vector<dim> velocity{{exact::not_given, exact::not_given}}; ///< by mass, cm/us
  };

  template <int dim>
  ExactMeans<dim>
  exact_means(const exact::ExactSolution<dim> &solution, const std::vector<VolumePoint<dim>> &points, double time);
} // namespace whipple
