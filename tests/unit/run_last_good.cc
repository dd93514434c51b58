// SPDX-License-Identifier: LGPL-2.1-or-later
// The last good state that a failed hand-over goes back to, from another mesh, is complete: its totals can be summed.
#include <whipple/ledger/totals.h>
#include <whipple/run/handover.h>
#include <whipple/run/last_good.h>

#include <gtest/gtest.h>

#include <filesystem>
#include <fstream>

namespace
{
  using namespace whipple;

  Problem<2>
  flying_block(const std::string &directory)
  {
    const std::string path = directory + "/scene.prm";
    std::ofstream(path)
        << "subsection Geometry\n set Symmetry = axisymmetric\n set Lower corner = 0 cm, 0 cm\n"
           " set Upper corner = 0.6 cm, 0.6 cm\nend\n"
           "subsection Mesh\n set Finest cell = 0.1 cm\n set Levels = 0\n set Refinement = uniform\nend\n"
           "subsection Materials\n set List = al\n subsection al\n set Library = aluminium 2024-T4\n end\nend\n"
           "subsection Bodies\n set List = block\n subsection block\n set Shape = box\n"
           " set Lower corner = 0.1 cm, 0.2 cm\n set Upper corner = 0.35 cm, 0.4 cm\n"
           " set Velocity = 0 km/s, 3 km/s\n set Material = al\n end\nend\n"
           "subsection Stages\n set List = flight\n subsection flight\n set Mode = eulerian\n set End = 1 us\n "
           "end\nend\n";
    return read_problem<2>(path);
  }

  TEST(LastGood, HasItsTotalsOnceRestoredFromAnotherMesh)
  {
    const std::string directory = testing::TempDir() + "whipple_last_good";
    std::filesystem::create_directories(directory);
    const Problem<2>    problem = flying_block(directory);
    const Scene<2>     &scene   = problem.scene;
    const FieldLayout  &layout  = problem.layout;
    const Regridding<2> regridding(scene, layout);
    const Handover<2>   handover(problem, regridding);
    RunState<2>         run{{Forest<2>(MPI_COMM_SELF, scene.lattice), nullptr, {}}, {}};
    handover.enter(scene.stages[0], nullptr, run.domain, run.books.ledger, run.books.waiting);
    for (double &mass : run.domain.state.node_mass) // carried: not to the last bit what the cells' masses add up to
      mass *= 1. + 1e-6;
    const auto before = totals(run.domain.view->mesh, run.domain.state, MPI_COMM_SELF);
    ASSERT_GT(before.kinetic_energy, 0.);

    LastGood<2> last_good;
    last_good.keep(run);
    // a mesh that has come in between and holds nothing yet
    run.domain.view = run.domain.forest.flatten(std::vector<std::uint8_t>(run.domain.forest.leaves().size(), 1), 0,
                                                Cohesion::fragments);
    clear_state(layout, run.domain);
    EXPECT_TRUE(last_good.restore(layout, run));
    const auto after = totals(run.domain.view->mesh, run.domain.state, MPI_COMM_SELF);
    EXPECT_EQ(after.mass, before.mass);
    EXPECT_EQ(after.internal_energy, before.internal_energy);
    EXPECT_NEAR(after.kinetic_energy, before.kinetic_energy, 1e-14 * before.kinetic_energy);
    EXPECT_NEAR(after.momentum[1], before.momentum[1], 1e-14 * before.momentum[1]);
    std::filesystem::remove_all(directory);
  }
} // namespace
