// SPDX-License-Identifier: LGPL-2.1-or-later
// What the pass of an effect throws on one rank only stops the cycle on all of them.
#include "source_directory.h"

#include <whipple/effect/effect.h>
#include <whipple/error.h>
#include <whipple/run/cycle.h>
#include <whipple/run/handover.h>

#include <gtest/gtest.h>

namespace
{
  using namespace whipple;

  /// Fails on the last rank: in the step or when it is asked for a time step.
  class FailingPass : public EffectPass<2>
  {
  public:
    explicit FailingPass(bool in_step)
      : in_step_(in_step)
    {
    }

    void
    advance(const EffectStep<2> &) override
    {
      if (in_step_)
        fail();
    }

    TimeStepLimit
    time_step(const State<2> &state) const override
    {
      if (!in_step_)
        fail();
      return EffectPass<2>::time_step(state);
    }

  private:
    static void
    fail()
    {
      int rank = 0, ranks = 1;
      MPI_Comm_rank(MPI_COMM_WORLD, &rank);
      MPI_Comm_size(MPI_COMM_WORLD, &ranks);
      if (rank == ranks - 1)
        throw StateError("a pass failed on rank " + std::to_string(rank));
    }

    bool in_step_;
  };

  EffectDescription
  description(const char *name)
  {
    return {name, "fails on one rank", "Of the tests."};
  }

  const EffectRegistration<2> step_fails(900, description("test: step fails"),
                                         [](const EffectSetup<2> &) { return std::make_unique<FailingPass>(true); });
  const EffectRegistration<2> limit_fails(900, description("test: limit fails"),
                                          [](const EffectSetup<2> &) { return std::make_unique<FailingPass>(false); });

  /// What every rank gets to know of a failure in a cycle with an effect; empty if nothing failed here.
  std::string
  failure_with(const std::string &effect)
  {
    Problem<2> problem =
        read_problem<2>(source_directory() + "/prm/verification/noh_spherical.prm", {"Mesh/Finest cell = 0.05 cm"});
    Scene<2>           &scene  = problem.scene;
    const FieldLayout  &layout = problem.layout;
    const Regridding<2> regridding(scene, layout);
    Domain<2>           domain{Forest<2>(MPI_COMM_WORLD, scene.lattice), nullptr, {}};
    Ledger<2>           ledger;
    SharedDebris<2>     waiting;
    Handover<2>(problem, regridding).enter(scene.stages[0], nullptr, domain, ledger, waiting);
    scene.effects.push_back(effect);
    PhaseClock phases;
    Cycle<2>   cycle(scene, scene.stages[0], layout, domain.view->mesh, domain.view->halo, phases);
    cycle.refresh(domain.state, domain.derived);
    try
      {
        const double dt = cycle.time_step(domain.state, domain.derived, {}).dt;
        cycle.advance(domain.state, domain.derived, 0.1 * dt, 0, {}, ledger);
      }
    catch (const StateError &error)
      {
        return error.what();
      }
    return "";
  }

  TEST(CycleRanks, APassThatFailsOnOneRankStopsAll)
  {
    int ranks = 1;
    MPI_Comm_size(MPI_COMM_WORLD, &ranks);
    const std::string expected = "a pass failed on rank " + std::to_string(ranks - 1);
    EXPECT_EQ(failure_with("test: step fails"), expected);
    EXPECT_EQ(failure_with("test: limit fails"), expected);
    EXPECT_EQ(failure_with("voids"), ""); // the same without them goes through
  }
} // namespace
