// SPDX-License-Identifier: LGPL-2.1-or-later
// Refinement by the gradient of a field: levels against the derivative of what the cells hold.
#include "source_directory.h"

#include <whipple/error.h>
#include <whipple/problem/level_need.h>
#include <whipple/run/resume.h>

#include <gtest/gtest.h>

#include <algorithm>
#include <cmath>
#include <filesystem>
#include <map>

namespace
{
  using namespace whipple;

  const std::vector<std::string> tube{"Mesh/Finest cell = 0.01 cm",     "Mesh/Levels = 2",
                                      "Mesh/Refinement = adaptive",     "Mesh/Buffer = 1",
                                      "Mesh/Gradient field = pressure", "Mesh/Gradient levels = 2",
                                      "Mesh/Gradient change = 2 %",     "Output/Fields interval = none"};

  Problem<2>
  shock_tube(std::vector<std::string> more)
  {
    more.insert(more.begin(), tube.begin(), tube.end());
    return read_problem<2>(source_directory() + "/prm/verification/sod.prm", more);
  }

  /// A shock tube after some time: where the pressure changes cells are fine, where no wave has come they give up both
  /// levels.
  TEST(GradientCriterion, FollowsTheFieldThatWasChosen)
  {
    std::filesystem::create_directories("gradient_output");
    const auto simulation = start(shock_tube({}), {"gradient_output/sod"}, EarlierRun::replaced, MPI_COMM_SELF);
    simulation->run();
    const FlatMesh<2> &mesh   = simulation->domain().view->mesh;
    const State<2>    &state  = simulation->domain().state;
    const Derived     &after  = simulation->domain().derived;
    const Problem<2>   judged = shock_tube({});
    const LevelNeed<2> need(judged.scene, judged.layout);
    const auto         levels  = need.of_cells(mesh, state, after, MPI_COMM_SELF);
    double             largest = 0;
    for (Index c = 0; c < mesh.n_owned; ++c)
      largest = std::max(largest, after.material[0].pressure[c]);

    int fine = 0;
    for (const FlatFaces<2> &faces : mesh.faces)
      for (Index f = 0; f < faces.size(); ++f)
        {
          const Index a = faces.cell[0][f], b = faces.cell[1][f];
          if (a == none || b == none)
            continue;
          // the derivative by the two cells of a face
          const double slope = std::abs(after.material[0].pressure[b] - after.material[0].pressure[a]) * 2. /
                               (mesh.size[a] + mesh.size[b]);
          const double change = slope * judged.scene.lattice.spacing / largest;
          if (change > 0.02) // more than the finest cells are to show: no level is given up
            {
              EXPECT_EQ(levels[a], judged.scene.lattice.max_level);
              EXPECT_EQ(levels[b], judged.scene.lattice.max_level);
              ++fine;
            }
        }
    EXPECT_GT(fine, 0);
    int at_rest = 0;
    for (Index c = 0; c < mesh.n_owned; ++c)
      {
        EXPECT_GE(levels[c], judged.scene.lattice.max_level - 2);
        const double z = mesh.lower[1][c];
        if (z < 0.2 || z > 0.95) // no wave has come there
          {
            EXPECT_EQ(levels[c], judged.scene.lattice.max_level - 2) << z;
            ++at_rest;
          }
      }
    EXPECT_GT(at_rest, 0);
  }

  TEST(GradientCriterion, FieldsThatNothingCarriesAreRefused)
  {
    EXPECT_THROW(shock_tube({"Mesh/Gradient field = plastic strain"}), InputError); // a gas without strength
    EXPECT_THROW(shock_tube({"Mesh/Gradient field = presure"}), InputError);
    EXPECT_THROW(shock_tube({"Mesh/Gradient levels = 0"}), InputError);
    EXPECT_NO_THROW(shock_tube({"Mesh/Gradient field = speed"}));
    try
      {
        shock_tube({"Mesh/Gradient field = presure"});
      }
    catch (const InputError &error)
      {
        EXPECT_NE(std::string(error.what()).find("allowed are density, pressure"), std::string::npos) << error.what();
      }
  }
} // namespace
