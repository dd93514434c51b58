// SPDX-License-Identifier: LGPL-2.1-or-later
// Moving meshes that start sheared or polar, and sides that press, through the program's own chain of stages.
#include "fastest_node.h"

#include <whipple/ledger/totals.h>
#include <whipple/output/output_directory.h>
#include <whipple/run/simulation.h>

#include <gtest/gtest.h>

#include <cmath>
#include <cstdio>
#include <filesystem>
#include <fstream>
#include <memory>
#include <numbers>

namespace
{
  using namespace whipple;

  /// Gas of 1 g/cm^3 and 1 Mbar in a domain of 1 cm (axis 0) x 4 cm (axis 1).
  std::string
  gas_scene(const std::string &geometry, const std::string &mode)
  {
    return "subsection Geometry\n set Lower corner = 0 cm, 0 cm\n set Upper corner = 1 cm, 4 cm\n" + geometry +
           "end\nsubsection Mesh\n set Finest cell = 0.125 cm\n set Levels = 0\n set Refinement = uniform\nend\n"
           "subsection Materials\n set List = gas\n subsection gas\n set Equation of state = ideal gas\n"
           " set Density = 1 g/cm^3\n set Adiabatic exponent = 1.4\n end\nend\n"
           "subsection Bodies\n set List = gas\n subsection gas\n set Shape = box\n set Lower corner = 0 cm, 0 cm\n"
           " set Upper corner = 1 cm, 4 cm\n set Material = gas\n set Pressure = 1 Mbar\n end\nend\n"
           "subsection Stages\n set List = s\n subsection s\n set Mode = " +
           mode + "\n set End = 0.2 us\n end\nend\n";
  }

  Problem<2>
  scene_of(const std::string &text, const std::vector<std::string> &overrides = {})
  {
    const std::string path = testing::TempDir() + "whipple_mesh_map.prm";
    std::ofstream(path) << text;
    try
      {
        const Problem<2> scene = read_problem<2>(path, overrides);
        std::remove(path.c_str());
        return scene;
      }
    catch (const InputError &)
      {
        std::remove(path.c_str());
        throw;
      }
  }

  std::unique_ptr<Simulation<2>>
  run(const Problem<2> &scene)
  {
    const std::string directory = testing::TempDir() + "whipple_mesh_map_output";
    std::filesystem::remove_all(directory);
    prepare_output_directory(directory, EarlierRun::replaced, MPI_COMM_SELF);
    auto simulation = std::make_unique<Simulation<2>>(scene, RunPlace{directory}, MPI_COMM_SELF);
    simulation->run();
    return simulation;
  }

  const std::string walls = " set Left = reflecting\n set Right = reflecting\n set Bottom = reflecting\n"
                            " set Top = reflecting\n";

  TEST(MeshMap, PointsAreWhereTheFormulasSay)
  {
    const Vector<2> lower{{0., 0.}}, upper{{0.1, 1.}};
    const auto      saltzman = mapped_point(MeshMap::saltzman, lower, upper, {{0.025, 0.25}});
    EXPECT_EQ(saltzman[0], 0.025);
    EXPECT_DOUBLE_EQ(saltzman[1], 0.25 + 0.075 * std::sqrt(0.5));
    EXPECT_EQ(mapped_point(MeshMap::saltzman, lower, upper, {{0.025, 1.}})[1], 1.);
    const auto lying = mapped_point(MeshMap::saltzman, lower, {{1., 0.1}}, {{0.5, 0.}});
    EXPECT_DOUBLE_EQ(lying[0], 0.6);
    const auto polar = mapped_point(MeshMap::polar, {{0.5, 1.}}, {{2., 4.}}, {{2., 2.}});
    EXPECT_DOUBLE_EQ(polar[0], std::sqrt(3.));
    EXPECT_DOUBLE_EQ(polar[1], 1.);
    EXPECT_EQ(mapped_point(MeshMap::polar, {{0.5, 1.}}, {{2., 4.}}, {{2., 4.}})[0], 0.); // the axis
    EXPECT_EQ(mapped_point(MeshMap::polar, {{0.5, 1.}}, {{2., 4.}}, {{2., 1.}})[1], 0.); // the equator
  }

  TEST(MeshMap, SkewedCellsHoldTheWholeDomain)
  {
    for (const std::string symmetry : {"planar", "axisymmetric"})
      {
        const auto s = run(
            scene_of(gas_scene(" set Mesh map = saltzman\n set Symmetry = " + symmetry + "\n" + walls, "lagrangian")));
        const double volume = symmetry == "planar" ? 4. : 4. * std::numbers::pi;
        EXPECT_NEAR(s->ledger().introduced().mass, volume, 1e-12 * volume);
        EXPECT_LT(fastest_node(s->domain().state), 1e-13);
      }
  }

  // A shell of gas between two arcs, the pressure outside its own: everything that a polar mesh is made of at work.
  TEST(MeshMap, PolarShellUnderPressureStaysAtRest)
  {
    for (const std::string symmetry : {"planar", "axisymmetric"})
      {
        const std::string sides = " set Mesh map = polar\n set Symmetry = " + symmetry +
                                  "\n set Left = pressure 1 Mbar\n set Right = pressure 1 Mbar\n"
                                  " set Bottom = reflecting\n set Top = reflecting\n";
        const auto s =
            run(scene_of(gas_scene(sides, "lagrangian"),
                         {"Geometry/Lower corner = 0.5 cm, 0 cm", "Geometry/Upper corner = 1.5 cm, 4 cm",
                          "Bodies/gas/Lower corner = 0.5 cm, 0 cm", "Bodies/gas/Upper corner = 1.5 cm, 4 cm"}));
        // a quarter of the ring, half of the shell, as polygons of 32 edges
        const double volume =
            symmetry == "planar" ? std::numbers::pi / 2. : std::numbers::pi * 2. / 3. * (3.375 - 0.125);
        EXPECT_NEAR(s->ledger().introduced().mass, volume, 1e-3 * volume);
        EXPECT_LT(fastest_node(s->domain().state), 1e-13) << symmetry;
      }
  }

  // Twice the pressure: the shell moves inwards the same way in all directions, its sides stay where they are.
  TEST(MeshMap, PolarShellMovesRadially)
  {
    const auto         s     = run(scene_of(gas_scene(" set Mesh map = polar\n set Symmetry = axisymmetric\n"
                                                                  " set Left = inflow 0 cm/us, 0 cm/us\n set Right = pressure 2 Mbar\n"
                                                                  " set Bottom = reflecting\n set Top = reflecting\n",
                                                      "lagrangian")));
    const FlatMesh<2> &mesh  = s->domain().view->mesh;
    const State<2>    &state = s->domain().state;
    double             least = 10, most = 0;
    for (Index n = 0; n < mesh.n_nodes; ++n)
      {
        if (mesh.node_side[n] >> 1 & 1)
          {
            const double r = std::hypot(state.position[0][n], state.position[1][n]);
            least          = std::min(least, r);
            most           = std::max(most, r);
          }
        if (mesh.node_side[n] >> 2 & 1)
          {
            EXPECT_EQ(state.position[1][n], 0.);
          }
        if (mesh.node_side[n] >> 3 & 1)
          {
            EXPECT_EQ(state.position[0][n], 0.);
          }
      }
    EXPECT_LT(most, 0.97);
    EXPECT_LT(most / least, 1.01);
    EXPECT_LT(*s->summary().ledger.energy.closure_relative, 1e-12);
  }

  const std::string strip = " set Symmetry = planar\n set Left = reflecting\n set Right = reflecting\n"
                            " set Top = reflecting\n set Bottom = pressure ";

  TEST(PressureSide, PushesAMovingMesh)
  {
    const auto  s      = run(scene_of(gas_scene(strip + "2 Mbar\n", "lagrangian")));
    const auto &ledger = s->summary().ledger;
    // for 0.2 us 2 Mbar from below and, its end not reached yet, 1 Mbar of the wall above, on 1 cm^2
    EXPECT_NEAR(ledger.axial_momentum.final_value, 0.2, 1e-12);
    EXPECT_GT(ledger.energy.final_value, ledger.energy.initial);
    EXPECT_LT(*ledger.energy.closure_relative, 1e-12);
  }

  // Gas of 1 Mbar behind a side of 0.5 Mbar: a fan runs into it, and through the side it leaves as its isentrope says.
  TEST(PressureSide, GasLeavesAFixedMeshIntoALowerPressure)
  {
    const auto   s    = run(scene_of(gas_scene(strip + "0.5 Mbar\n", "eulerian"), {"Mesh/Finest cell = 0.03125 cm"}));
    const double part = std::pow(0.5, 1. / 7.), velocity = 5. * std::sqrt(1.4) * (1. - part); // (k-1)/2k = 1/7
    EXPECT_NEAR(s->summary().ledger.mass.left_domain, std::pow(0.5, 1. / 1.4) * velocity * 0.2, 2e-3);
    EXPECT_LT(*s->summary().ledger.energy.closure_relative, 1e-12);
    EXPECT_LT(*s->summary().ledger.axial_momentum.closure_relative, 1e-12);
  }

  TEST(MeshMap, SceneSaysWhatIsWrong)
  {
    const auto complaint = [](const std::string &geometry, const std::string &mode,
                              const std::vector<std::string> &overrides = {}) -> std::string {
      try
        {
          scene_of(gas_scene(geometry, mode), overrides);
        }
      catch (const InputError &error)
        {
          return error.what();
        }
      return "";
    };
    EXPECT_NE(complaint(" set Mesh map = polar\n set Right = pressure 1 Mbar\n", "lagrangian").find("Geometry/Left"),
              std::string::npos);
    EXPECT_NE(complaint(" set Mesh map = saltzman\n" + walls, "eulerian").find("Geometry/Mesh map = 'saltzman'"),
              std::string::npos);
    EXPECT_NE(complaint(" set Mesh map = saltzman\n" + walls, "lagrangian",
                        {"Geometry/Upper corner = 1 cm, 2 cm", "Bodies/gas/Upper corner = 1 cm, 2 cm"})
                  .find("folds the mesh"),
              std::string::npos);
    EXPECT_NE(complaint(" set Right = exact\n", "eulerian").find("Geometry/Right = 'exact': the scene names no exact"),
              std::string::npos);
    EXPECT_NE(complaint(" set Right = pressure 1\n", "eulerian").find("the unit is missing"), std::string::npos);
  }
} // namespace
