// SPDX-License-Identifier: LGPL-2.1-or-later
#pragma once

#include <whipple/mesh/halo.h>

#include <functional>
#include <span>
#include <utility>
#include <vector>

namespace whipple
{
  /// The halo as a pass of an effect may use it. Every call is collective, and a place where the ranks meet: if one of
  /// them has failed before it (StateError), all leave the pass with its error and nobody waits.
  template <int dim>
  class EffectHalo
  {
  public:
    /// @param meet collective; throws on all ranks if one has failed
    EffectHalo(const Halo<dim> &halo, std::function<void()> meet)
      : halo_(halo)
      , meet_(std::move(meet))
    {
    }

    /// Bring the owners' values into the halo: arrays of n_cells and of n_nodes values.
    void
    exchange(const std::vector<std::vector<double> *> &cells,
             const std::vector<std::vector<double> *> &nodes = {}) const
    {
      meet_();
      halo_.exchange(cells, nodes);
    }

    /// The largest of the ranks' values.
    double
    largest(double value) const
    {
      meet_();
      MPI_Allreduce(MPI_IN_PLACE, &value, 1, MPI_DOUBLE, MPI_MAX, halo_.communicator());
      return value;
    }

  private:
    const Halo<dim>      &halo_;
    std::function<void()> meet_;
  };
} // namespace whipple
