// SPDX-License-Identifier: LGPL-2.1-or-later
#pragma once

#include <whipple/scene/scene.h>
#include <whipple/state/conserved_totals.h>
#include <whipple/state/exact_sum.h>

#include <mpi.h>

#include <span>
#include <vector>

namespace whipple
{
  /// Books of a painting: whether the cells received what the bodies are. What a body is comes from its shape alone,
  /// the volume of the whole in closed form; what the cells received is the sum of their cuts.
  template <int dim>
  class PaintedBodies
  {
  public:
    /// @param bodies those that enter, indices into the scene
    PaintedBodies(const Scene<dim> &scene, std::span<const std::size_t> bodies);

    /// An owned cell has received this volume of the body (number `b` of those that enter), cm^3, and a cut of
    /// `rounded` (>= 0) has been left out as round-off.
    void
    add(std::size_t b, double volume, double rounded)
    {
      received_[2 * b].add(volume);
      received_[2 * b + 1].add(rounded);
    }

    /// Compare volumes. Collective; all ranks throw alike. Bodies on a mapped mesh have no such volume and pass.
    /// @throws ConservationError naming the body and both volumes
    void
    check(MPI_Comm communicator);

  private:
    const Scene<dim>            &scene_;
    std::span<const std::size_t> bodies_;
    std::vector<ExactSum>        received_; ///< per body: volume, volume left out
  };

  /// Compare what has come into the cells with what the bodies bring: mass and momentum of their whole volumes,
  /// energies of their states and deposits. Bodies with an exact state, and those on a mapped mesh, pass.
  /// @param entered totals after less totals before, and the impulse that walls took
  /// @throws ConservationError naming the quantity and both amounts
  template <int dim>
  void
  check_entered(const Scene<dim> &scene, std::span<const std::size_t> bodies, const ConservedTotals<dim> &entered);
} // namespace whipple
