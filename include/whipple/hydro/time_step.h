// SPDX-License-Identifier: LGPL-2.1-or-later
#pragma once

#include <whipple/hydro/hydro_parameters.h>
#include <whipple/hydro/step_work.h>
#include <whipple/state/derived.h>

#include <span>
#include <string>
#include <vector>

namespace whipple
{
  /// The largest stable time step and what set it.
  struct TimeStepLimit
  {
    double      dt;          ///< us; infinity where no owned cell holds material that carries sound
    std::string reason;      ///< "sound", "viscosity" or "volume change"
    Index       cell = none; ///< the cell that set it
  };

  /// Smallest over owned cells with material that is no trace of courant L / (d + sqrt(d^2 + c^2)) and
  /// max_volume_change / |div v|; d = 2 c2 |du| + c1 c in compression, scaled with the part of it that the materials
  /// take beside open void; c^2 = max(c_bulk^2, |P| / rho) + 4/3 G / rho.
  /// @param velocity of the nodes, those that sides prescribe already as the sides have it
  /// @param exempt owned cells, in ascending order, that keep their shape: nothing in them limits the step
  template <int dim>
  TimeStepLimit
  find_time_step(const FlatMesh<dim> &mesh, const State<dim> &state, const Derived &derived,
                 const std::array<std::vector<double>, dim> &velocity, const HydroParameters &parameters,
                 const StepWork<dim> &work, std::span<const Index> exempt = {});

  /// Owned cells that would limit the step to less than `bound` [us] because they are slivers: their smallest extent is
  /// less than a 25th of their longest side or diagonal.
  template <int dim>
  std::vector<Index>
  find_slivers(const FlatMesh<dim> &mesh, const State<dim> &state, const Derived &derived,
               const HydroParameters &parameters, const StepWork<dim> &work, double bound);
} // namespace whipple
