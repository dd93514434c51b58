// SPDX-License-Identifier: LGPL-2.1-or-later
// A plate of a scene, with a hole cut into its cells, is measured to the same bits on any number of ranks, and the same
// in a scene and its mirror image.
#include <whipple/diagnostics/plate_measure.h>
#include <whipple/run/handover.h>

#include <gtest/gtest.h>

#include <cmath>
#include <cstdio>
#include <fstream>
#include <string>

namespace
{
  using namespace whipple;

  /// Two plates of one material, 5 and 2 cells thick, told apart by tags; `geometry` says where the domain lies.
  Problem<2>
  scene_of(const std::string &geometry)
  {
    int rank = 0;
    MPI_Comm_rank(MPI_COMM_WORLD, &rank);
    const std::string path = testing::TempDir() + "whipple_plate_measure_" + std::to_string(rank) + ".prm";
    const auto        body = [](const std::string &name, const std::string &front, const std::string &thickness) {
      return " subsection " + name + "\n set Shape = plate\n set Front face = " + front +
             " cm\n set Thickness = " + thickness + " cm\n set Material = metal\n end\n";
    };
    std::ofstream(path) << "subsection Geometry\n" + geometry +
                               "end\nsubsection Mesh\n set Finest cell = 0.02 cm\n set Levels = 3\nend\n"
                               "subsection Materials\n set List = metal\n subsection metal\n"
                               " set Library = aluminium 2024-T4\n end\nend\n"
                               "subsection Effects\n set List = body tags\nend\n"
                               "subsection Bodies\n set List = bumper, wall\n" +
                               body("bumper", "0.01", "0.1") + body("wall", "0.5", "0.04") +
                               "end\nsubsection Stages\n set List = s\n subsection s\n set End = 1 us\n end\nend\n";
    const Problem<2> problem = read_problem<2>(path);
    std::remove(path.c_str());
    return problem;
  }

  /// Measure a plate of which nothing is left nearer than 0.153 cm to x = 0, and one small piece.
  PlateMeasure
  measure(const Problem<2> &problem, std::size_t body, MPI_Comm communicator)
  {
    const Scene<2>     &scene  = problem.scene;
    const FieldLayout  &layout = problem.layout;
    const Regridding<2> regridding(scene, layout);
    Domain<2>           domain{Forest<2>(communicator, scene.lattice), nullptr, {}};
    Ledger<2>           ledger;
    SharedDebris<2>     waiting;
    Handover<2>(problem, regridding).enter(scene.stages[0], nullptr, domain, ledger, waiting);
    const FlatMesh<2> &mesh = domain.view->mesh;
    for (Index c = 0; c < mesh.n_cells; ++c)
      {
        const double a    = std::min(std::abs(mesh.lower[0][c]), std::abs(mesh.lower[0][c] + mesh.size[c]));
        const double kept = std::clamp((a + mesh.size[c] - 0.153) / mesh.size[c], a < 0.05 ? 1. : 0., 1.);
        for (MaterialState &m : domain.state.material)
          for (auto *array : {&m.volume, &m.mass})
            (*array)[c] *= kept;
      }
    const auto result = measure_plate(scene, layout, body, mesh, domain.state, communicator);
    EXPECT_TRUE(result);
    return result.value_or(PlateMeasure{});
  }

  const std::string left_half =
      " set Symmetry = planar\n set Lower corner = 0 cm, -0.64 cm\n set Upper corner = 1.28 cm, 1.28 cm\n"
      " set Left = reflecting\n set Right = transmitting\n";
  const std::string right_half =
      " set Symmetry = planar\n set Lower corner = -1.28 cm, -0.64 cm\n set Upper corner = 0 cm, 1.28 cm\n"
      " set Left = transmitting\n set Right = reflecting\n";
  const std::string both_halves =
      " set Symmetry = planar\n set Lower corner = -1.28 cm, -0.64 cm\n set Upper corner = 1.28 cm, 1.28 cm\n"
      " set Left = transmitting\n set Right = transmitting\n";
  const std::string about_axis =
      " set Symmetry = axisymmetric\n set Lower corner = 0 cm, -0.64 cm\n set Upper corner = 1.28 cm, 1.28 cm\n";

  TEST(PlateMeasureRanks, SameBitsOnAnyNumber)
  {
    for (const std::string &geometry : {about_axis, both_halves})
      for (const std::size_t body : {0u, 1u})
        {
          const Problem<2>   problem = scene_of(geometry);
          const PlateMeasure all     = measure(problem, body, MPI_COMM_WORLD),
                             alone   = measure(problem, body, MPI_COMM_SELF);
          EXPECT_TRUE(alone.perforated);
          EXPECT_NEAR(alone.hole_diameter, 0.306, 0.002);
          EXPECT_GT(alone.detached_mass, 0.);
          EXPECT_EQ(all.perforated, alone.perforated);
          EXPECT_EQ(all.perforation_margin, alone.perforation_margin);
          EXPECT_EQ(all.hole_diameter, alone.hole_diameter);
          EXPECT_EQ(all.smallest_hole_diameter, alone.smallest_hole_diameter);
          EXPECT_EQ(all.crater_depth, alone.crater_depth);
          EXPECT_EQ(all.rear_bulge, alone.rear_bulge);
          EXPECT_EQ(all.front_lip, alone.front_lip);
          EXPECT_EQ(all.least_thickness, alone.least_thickness);
          EXPECT_EQ(all.detached_mass, alone.detached_mass);
        }
  }

  TEST(PlateMeasureRanks, MirroredAndHalvedScenesAgree)
  {
    const PlateMeasure left  = measure(scene_of(left_half), 0, MPI_COMM_WORLD),
                       right = measure(scene_of(right_half), 0, MPI_COMM_WORLD),
                       full  = measure(scene_of(both_halves), 0, MPI_COMM_WORLD);
    EXPECT_NEAR(left.hole_diameter, 0.306, 1e-3);
    EXPECT_NEAR(right.hole_diameter, left.hole_diameter, 1e-12);
    EXPECT_NEAR(full.hole_diameter, left.hole_diameter, 1e-12);
    EXPECT_NEAR(right.smallest_hole_diameter, left.smallest_hole_diameter, 1e-12);
    EXPECT_NEAR(full.detached_mass, 2. * left.detached_mass, 1e-12);
  }
} // namespace
