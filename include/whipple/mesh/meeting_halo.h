// SPDX-License-Identifier: LGPL-2.1-or-later
#pragma once

#include <whipple/mesh/halo.h>

#include <functional>
#include <utility>
#include <vector>

namespace whipple
{
  /// The halo as work may use it that can find a bad state on one rank only (agree_in_parts): the passes of effects,
  /// the sweeps of the remap. Every call is collective, and a place where the ranks meet: if one of them has failed
  /// before it (StateError), all leave the work with its error and nobody waits.
  template <int dim>
  class MeetingHalo
  {
  public:
    /// Of a rank that has the whole mesh: nobody to meet, nothing to exchange.
    MeetingHalo() = default;

    /// @param meet collective; throws on all ranks if one has failed
    MeetingHalo(const Halo<dim> &halo, std::function<void()> meet)
      : halo_(&halo)
      , meet_(std::move(meet))
    {
    }

    /// Bring the owners' values into the halo: arrays of n_cells and of n_nodes values.
    void
    exchange(const std::vector<std::vector<double> *> &cells,
             const std::vector<std::vector<double> *> &nodes = {}) const
    {
      if (!halo_)
        return;
      meet_();
      halo_->exchange(cells, nodes);
    }

    /// The largest of the ranks' values.
    double
    largest(double value) const
    {
      if (!halo_)
        return value;
      meet_();
      MPI_Allreduce(MPI_IN_PLACE, &value, 1, MPI_DOUBLE, MPI_MAX, halo_->communicator());
      return value;
    }

    /// Whether it is so on any rank.
    bool
    any(const bool here) const
    {
      return largest(here) > 0;
    }

  private:
    const Halo<dim>      *halo_ = nullptr;
    std::function<void()> meet_;
  };
} // namespace whipple
