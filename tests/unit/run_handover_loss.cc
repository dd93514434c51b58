// SPDX-License-Identifier: LGPL-2.1-or-later
// What becomes of the kinetic energy that a hand-over to a coarser mesh loses is for the stage to say.
#include <whipple/hydro/lagrange_step.h>
#include <whipple/ledger/totals.h>
#include <whipple/run/handover.h>

#include <gtest/gtest.h>

#include <cmath>
#include <cstdio>
#include <fstream>

namespace
{
  using namespace whipple;

  /// A cloud, and a second stage in which a plate enters.
  Problem<2>
  two_stages(const std::string &lost)
  {
    const std::string path = testing::TempDir() + "whipple_handover_loss.prm";
    std::ofstream(path)
        << "subsection Geometry\n set Symmetry = planar\n set Lower corner = 0 cm, 0 cm\n"
           " set Upper corner = 0.8 cm, 0.8 cm\n set Left = transmitting\n set Right = transmitting\n"
           " set Bottom = transmitting\n set Top = transmitting\nend\n"
           "subsection Mesh\n set Finest cell = 0.0125 cm\n set Levels = 3\n set Quiet levels = 0\nend\n"
           "subsection Materials\n set List = al\n subsection al\n set Library = aluminium 2024-T4\n"
           " set Void law = rate\n set Alpha = 1e5 us/cm^2\n set Spall strength = 1.2 GPa\n end\nend\n"
           "subsection Effects\n set List = voids\nend\n"
           "subsection Bodies\n set List = cloud, plate\n"
           " subsection cloud\n set Shape = box\n set Lower corner = 0.2 cm, 0.1 cm\n"
           " set Upper corner = 0.6 cm, 0.4 cm\n set Material = al\n end\n"
           " subsection plate\n set Shape = plate\n set Front face = 0.6 cm\n"
           " set Thickness = 0.1 cm\n set Material = al\n end\nend\n"
           "subsection Stages\n set List = flight, wall\n"
           " subsection flight\n set Mode = eulerian\n set Introduces = cloud\n set End = 1 us\n end\n"
           " subsection wall\n set Mode = eulerian\n set Introduces = plate\n set End = 2 us\n"
           " set Lost kinetic energy = "
        << lost << "\n end\nend\n";
    const Problem<2> problem = read_problem<2>(path);
    std::remove(path.c_str());
    return problem;
  }

  struct Entered
  {
    ConservedTotals<2> before, after;
    Ledger<2>          ledger;
  };

  /// The cloud expanded hundredfold and stirred, then handed over: it needs coarser cells.
  Entered
  hand_over(const std::string &lost)
  {
    const Problem<2>    problem = two_stages(lost);
    const Scene<2>     &scene   = problem.scene;
    const FieldLayout  &layout  = problem.layout;
    const Regridding<2> regridding(scene, layout);
    const Handover<2>   handover(problem, regridding);
    Domain<2>           domain{Forest<2>(MPI_COMM_SELF, scene.lattice), nullptr, {}};
    Entered             result;
    SharedDebris<2>     waiting;
    handover.enter(scene.stages[0], nullptr, domain, result.ledger, waiting);
    const FlatMesh<2> &mesh  = domain.view->mesh;
    MaterialState     &cloud = domain.state.material[0];
    for (Index c = 0; c < mesh.n_cells; ++c)
      if (cloud.mass[c] > 0)
        {
          cloud.mass[c] *= 0.01;
          cloud.density[c] *= 0.01;
          cloud.void_fraction[c] = 0.99;
        }
    for (Index n = 0; n < mesh.n_nodes; ++n)
      for (int d = 0; d < 2; ++d)
        domain.state.velocity[d][n] =
            domain.state.node_mass[n] > 0
                ? 0.1 * std::sin(300. * mesh.node_point[d][n] + 200. * mesh.node_point[1 - d][n])
                : 0.;
    LagrangeStep<2> step(mesh, layout.materials, scene.boundaries, scene.numerics.hydro);
    step.update_node_mass(domain.state);
    step.evaluate(domain.state, domain.derived);
    result.before = totals(mesh, domain.state, MPI_COMM_SELF);
    handover.enter(scene.stages[1], &scene.stages[0], domain, result.ledger, waiting);
    result.after = totals(domain.view->mesh, domain.state, MPI_COMM_SELF);
    return result;
  }

  TEST(RunHandoverLoss, TheStageSaysWhetherItHeatsOrIsDropped)
  {
    const Entered heated = hand_over("heat"), dropped = hand_over("drop");
    const double  lost = heated.before.kinetic_energy - heated.after.kinetic_energy;
    ASSERT_GT(lost, 0.1 * heated.before.kinetic_energy); // it did coarsen
    EXPECT_NEAR(heated.after.total_energy(), heated.before.total_energy(), 1e-12 * heated.before.kinetic_energy);
    EXPECT_FALSE(heated.ledger.bookings().of("regrid").dropped.has_value());

    EXPECT_NEAR(dropped.after.kinetic_energy, heated.after.kinetic_energy, 1e-12 * lost);
    EXPECT_NEAR(dropped.after.internal_energy, dropped.before.internal_energy, 1e-12 * lost);
    ASSERT_TRUE(dropped.ledger.bookings().of("regrid").dropped.has_value());
    EXPECT_NEAR(dropped.ledger.bookings().of("regrid").dropped->kinetic_energy, lost, 1e-12 * lost);
  }
} // namespace
