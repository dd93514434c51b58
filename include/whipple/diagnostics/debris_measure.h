// SPDX-License-Identifier: LGPL-2.1-or-later
#pragma once

#include <whipple/mesh/flat_mesh.h>
#include <whipple/projection/waiting_debris.h>
#include <whipple/state/fields.h>

#include <mpi.h>

#include <functional>

namespace whipple
{
  /// Shape and motion of a debris cloud flying along axis 1. Quantiles are by mass, so that a stray milligram
  /// changes nothing.
  struct DebrisMeasure
  {
    double mass                  = 0; ///< g
    double axial_momentum        = 0; ///< g cm/us
    double mass_velocity         = 0; ///< cm/us, momentum over mass
    double leading_edge          = 0; ///< cm along axis 1, behind it flies 99.9 % of the mass
    double leading_edge_velocity = 0; ///< cm/us, mean of the foremost 1 % of the mass
    double length                = 0; ///< cm between 0.1 % and 99.9 % of the mass
    double radius                = 0; ///< cm, holds 99 % of the mass
    double radius_95             = 0; ///< cm, holds 95 % of the mass
    double depth_95              = 0; ///< cm behind `origin`, holds 95 % of the mass
    /// degrees, full angle under which `radius_95` is seen from the point of impact at the distance of the leading edge
    double cone_angle = 0;
  };

  /// Measure the owned cells of all ranks for which `belongs` holds; the cone's tip is on the axis at `origin` (cm
  /// along axis 1). Cells count with their centre and their corner-mass-weighted velocity. Collective.
  template <int dim>
  DebrisMeasure
  measure_debris(const FlatMesh<dim> &mesh, const State<dim> &state, const std::function<bool(Index cell)> &belongs,
                 double origin, MPI_Comm communicator, const WaitingDebris<dim> *waiting = nullptr);

  /// Largest coordinate along axis 1 that any owned cell with material reaches, over all ranks, cm.
  template <int dim>
  double
  foremost_point(const FlatMesh<dim> &mesh, const State<dim> &state, MPI_Comm communicator);
} // namespace whipple
