// SPDX-License-Identifier: LGPL-2.1-or-later
// Fragments that stop deforming are heated before the step: pressure and time step are those of the hot material.
#include <whipple/run/reporter.h>
#include <whipple/run/stage_loop.h>

#include <gtest/gtest.h>

#include <array>
#include <cmath>
#include <filesystem>
#include <fstream>
#include <sstream>

namespace
{
  using namespace whipple;

  constexpr double edge = 0.1, swirl = 0.6; // cm, cm/us

  /// One element of aluminium that flies alone.
  Problem<2>
  lone_element(const std::string &directory)
  {
    const std::string path = directory + "/scene.prm";
    std::ofstream(path)
        << "subsection Geometry\n set Symmetry = planar\n set Lower corner = 0 cm, 0 cm\n"
           " set Upper corner = 0.5 cm, 0.5 cm\n set Left = transmitting\n set Right = transmitting\n"
           " set Bottom = transmitting\n set Top = transmitting\nend\n"
           "subsection Mesh\n set Finest cell = 0.1 cm\n set Levels = 0\n set Refinement = uniform\nend\n"
           "subsection Materials\n set List = al\n subsection al\n set Library = aluminium 2024-T4\n"
           " set Void law = rate\n set Alpha = 1e5 us/cm^2\n set Spall strength = 1.2 GPa\n end\nend\n"
           "subsection Effects\n set List = voids\nend\n"
           "subsection Bodies\n set List = piece\n subsection piece\n set Shape = box\n"
           " set Lower corner = 0.2 cm, 0.2 cm\n set Upper corner = 0.3 cm, 0.3 cm\n"
           " set Material = al\n end\nend\n"
           "subsection Stages\n set List = flight\n subsection flight\n set Mode = lagrangian\n"
           " set Cohesion = fragments\n set End = 1 us\n end\nend\n"
           "subsection Output\n set Fields interval = none\n set Statistics interval = 0 us\nend\n";
    return read_problem<2>(path);
  }

  /// Entry of the first row of a statistics table.
  double
  first_entry(const std::string &file, const std::string &name)
  {
    std::ifstream table(file);
    std::string   head, row, title, entry;
    while (std::getline(table, head) && head.find(name) == std::string::npos)
      continue;
    std::getline(table, row);
    std::istringstream titles(head), entries(row);
    while (std::getline(titles, title, ',') && std::getline(entries, entry, ','))
      if (title.find(name) != std::string::npos)
        return std::stod(entry);
    return std::nan("");
  }

  TEST(RunRelease, TheStepIsThatOfTheHeatedFragment)
  {
    const std::string directory = testing::TempDir() + "whipple_run_release";
    std::filesystem::create_directories(directory);
    const Problem<2>    problem = lone_element(directory);
    const Scene<2>     &scene   = problem.scene;
    const FieldLayout  &layout  = problem.layout;
    const Regridding<2> regridding(scene, layout);
    const Handover<2>   handover(problem, regridding);
    RunState<2>         run{{Forest<2>(MPI_COMM_SELF, scene.lattice), nullptr, {}}, {}};
    Domain<2>          &domain = run.domain;
    Ledger<2>           ledger;
    SharedDebris<2>     waiting;
    handover.enter(scene.stages[0], nullptr, domain, ledger, waiting);
    ASSERT_EQ(domain.view->mesh.n_cells, 1);

    // an hourglass that would fold at once: no change of volume, all of its kinetic energy turns into heat
    const double energy_0 = domain.state.material[0].energy[0];
    for (int k = 0; k < 4; ++k)
      domain.state.velocity[0][domain.view->mesh.cell_node[k]] = k == 0 || k == 3 ? swirl : -swirl;
    run.books.ledger.introduce(totals(domain.view->mesh, domain.state, MPI_COMM_SELF));
    {
      Reporter<2> reporter(problem, directory, false, MPI_COMM_SELF, nullptr);
      LastGood<2> last_good;
      last_good.keep_books(run.books);
      PhaseClock phases;
      StageLoop<2>(
          scene, layout, regridding, handover, scene.stages[0], reporter, [] {}, run, last_good, phases)
          .run();
      reporter.flush();
    }
    EXPECT_GE(run.books.summary.counts.releases, 1);

    const std::array<double, 1> density{scene.bodies[0].density}, energy{energy_0 + 0.5 * swirl * swirl};
    std::array<double, 1>       pressure{{0.}}, speed_2{{0.}};
    layout.materials[0].eos->evaluate(density, energy, pressure, speed_2);
    const double hot = scene.numerics.hydro.courant * edge / std::sqrt(std::max(speed_2[0], pressure[0] / density[0]));
    layout.materials[0].eos->evaluate(density, std::array<double, 1>{{energy_0}}, pressure, speed_2);
    const double cold = scene.numerics.hydro.courant * edge / std::sqrt(speed_2[0]);
    ASSERT_LT(hot, 0.9 * cold);
    EXPECT_NEAR(first_entry(directory + "/statistics.csv", "time step [us]"), hot, 1e-6 * hot);
    std::filesystem::remove_all(directory);
  }
} // namespace
