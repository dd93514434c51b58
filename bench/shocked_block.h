// SPDX-License-Identifier: LGPL-2.1-or-later
#pragma once

#include <whipple/problem/problem.h>
#include <whipple/run/cycle.h>
#include <whipple/run/domain.h>

#include <memory>
#include <string>
#include <vector>

namespace whipple::bench
{
  /// Steps a state on one mesh as a stage does: time step, Lagrange step, effects, remap; no regrid, no output.
  class CycleRun
  {
  public:
    /// All references must outlive the object.
    CycleRun(const Problem<2> &problem, const FlatPartition<2> &view, State<2> state);

    /// @throws StateError as Cycle::advance()
    void
    step();

    const State<2> &
    state() const
    {
      return state_;
    }

  private:
    const Scene<2> &scene_;
    State<2>        state_;
    Derived         derived_;

    std::unique_ptr<PhaseClock> phases_ = std::make_unique<PhaseClock>(); // the cycle may be moved with the rest
    Cycle<2>                    cycle_;
    Ledger<2>                   ledger_;
    double                      last_dt_ = 0; ///< us; 0 before the first step
    int                         steps_   = 0;
  };

  /// The scene bench/shocked_block.prm with some effects, as it is at the end of its stage.
  class ShockedBlock
  {
  public:
    /// @param mode    of the stage, as scenes spell it
    /// @param effects that are on; the material has models for all effects that the program has
    /// @throws InputError, StateError as any run
    ShockedBlock(const std::string &mode, const std::vector<std::string> &effects);

    /// Goes on from the end of the stage.
    CycleRun
    resume() const;

    Index
    n_cells() const
    {
      return domain_.view->mesh.n_cells;
    }

    /// Cells that hold material.
    Index
    n_filled() const;

    /// Quantities a cell that the effects registered, the void fraction not among them.
    std::size_t
    n_fields() const
    {
      return problem_.layout.fields.size();
    }

  private:
    Problem<2> problem_;
    Domain<2>  domain_;
  };

  /// Whether the program has all of these effects: an effect of which the source is left out of a build registers
  /// nothing.
  bool
  has_effects(const std::vector<std::string> &effects);
} // namespace whipple::bench
