// SPDX-License-Identifier: LGPL-2.1-or-later
#pragma once

#include <whipple/mesh/mesh_image.h>
#include <whipple/run/run_clock.h>
#include <whipple/run/run_state.h>

#include <memory>

namespace whipple
{
  /// The last state of a run that is known to be good: what a failed step, regrid or projection goes back to, what a
  /// checkpoint writes, and what is on disk after a failure. A copy of the run state, with the mesh as an image, so
  /// that it stays what it is however forest and fields change.
  template <int dim>
  class LastGood
  {
  public:
    /// Remember a state that has a mesh. Collective if the mesh is another one than last time.
    void
    keep(const RunState<dim> &run);

    /// Before there is a mesh: remember the books alone.
    void
    keep_books(const RunBooks<dim> &books);

    /// Enter what has been used up to now into its books. Collective.
    void
    read_clock(const RunClock &clock)
    {
      clock.read(books_.summary.performance);
    }

    /// Make `run` what was kept. Collective. The mesh is rebuilt only if it is another one; its leaves may then lie on
    /// other ranks than before.
    /// @returns whether the mesh was rebuilt
    bool
    restore(const FieldLayout &layout, RunState<dim> &run);

    /// Steps of its stage. @pre it is in one
    long
    steps() const
    {
      return books_.summary.stages.back().steps;
    }

    const RunBooks<dim> &
    books() const
    {
      return books_;
    }
    /// Null before there is a mesh.
    const MeshImage *
    mesh() const
    {
      return image_.get();
    }
    /// What its state lies on.
    const std::shared_ptr<const FlatPartition<dim>> &
    view() const
    {
      return view_;
    }
    const State<dim> &
    state() const
    {
      return state_;
    }

  private:
    std::shared_ptr<const FlatPartition<dim>> view_; ///< what state_ lies on
    std::shared_ptr<const MeshImage>          image_;
    State<dim>                                state_;
    RunBooks<dim>                             books_;
  };
} // namespace whipple
