// SPDX-License-Identifier: LGPL-2.1-or-later
#pragma once

#include <whipple/run/checkpoint_store.h>
#include <whipple/run/interruption.h>
#include <whipple/run/reporter.h>
#include <whipple/run/run_clock.h>

namespace whipple
{
  /// When a run writes checkpoints: by the clock, at the end of each stage, and when it is asked to.
  template <int dim>
  class Checkpointing
  {
  public:
    /// @param directory  of the run
    /// @param wall_start MPI_Wtime at which the wall time limit starts to count
    /// @param clock      kept by reference
    Checkpointing(const Scene<dim> &scene, const FieldLayout &layout, const std::string &directory, double wall_start,
                  const RunClock &clock, MPI_Comm communicator);

    /// Look whether a checkpoint is due, and write the last good state if so. Collective.
    /// @throws Interrupted on all ranks, after the checkpoint, if the run shall stop
    void
    after_step(LastGood<dim> &last_good, Reporter<dim> &reporter);

    /// Write one. Collective. A disk that refuses is a warning: the run goes on.
    /// @returns where it is; empty if the disk refused
    std::string
    write(LastGood<dim> &last_good, Reporter<dim> &reporter);

  private:
    std::string          directory_; ///< of the run
    CheckpointStore<dim> store_;
    Interruption         interruption_;
    const RunClock      &clock_;
  };
} // namespace whipple
