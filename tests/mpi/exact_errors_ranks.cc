// SPDX-License-Identifier: LGPL-2.1-or-later
// Errors against an exact solution and the shock's position are the same bits on any number of ranks.
#include "source_directory.h"

#include <whipple/diagnostics/exact_errors.h>
#include <whipple/diagnostics/shock_measure.h>
#include <whipple/hydro/lagrange_step.h>
#include <whipple/run/handover.h>

#include <gtest/gtest.h>

namespace
{
  using namespace whipple;

  struct Measured
  {
    std::map<std::string, summary::Error> errors;
    std::optional<ShockMeasure>           shock;
  };

  /// Noh's implosion as it starts, against the same 0.3 us later.
  Measured
  measure(MPI_Comm communicator)
  {
    const Problem<2>    problem = read_problem<2>(source_directory() + "/prm/verification/noh_spherical.prm",
                                               {"Mesh/Finest cell = 0.05 cm", "Exact solution/Start time = 0.3 us"});
    const Scene<2>     &scene   = problem.scene;
    const FieldLayout  &layout  = problem.layout;
    const Regridding<2> regridding(scene, layout);
    Domain<2>           domain{Forest<2>(communicator, scene.lattice), nullptr, {}};
    Ledger<2>           ledger;
    SharedDebris<2>     waiting;
    Handover<2>(problem, regridding).enter(scene.stages[0], nullptr, domain, ledger, waiting);
    LagrangeStep<2>(domain.view->mesh, layout.materials, scene.boundaries, scene.numerics.hydro)
        .evaluate(domain.state, domain.derived);
    domain.state.time = 0.3;
    return {exact_errors<2>(*problem.exact, domain.view->mesh, domain.state, domain.derived, communicator),
            measure_shock<2>(problem, domain.view->mesh, domain.state, communicator)};
  }

  TEST(ExactErrorsRanks, SameBitsOnAnyNumber)
  {
    const Measured all = measure(MPI_COMM_WORLD), alone = measure(MPI_COMM_SELF);
    ASSERT_EQ(all.errors.size(), 4u);
    for (const auto &[name, error] : alone.errors)
      {
        EXPECT_GT(*error.l1, 0.) << name;
        EXPECT_EQ(*all.errors.at(name).l1, *error.l1) << name;
        EXPECT_EQ(*all.errors.at(name).l2, *error.l2) << name;
        EXPECT_EQ(*all.errors.at(name).linf, *error.linf) << name;
      }
    ASSERT_TRUE(all.shock && all.shock->mean && alone.shock && alone.shock->mean);
    EXPECT_EQ(*all.shock->mean, *alone.shock->mean);
    EXPECT_EQ(*all.shock->spread, *alone.shock->spread);
    EXPECT_EQ(all.shock->exact, 0.2);
  }
} // namespace
