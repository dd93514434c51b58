// SPDX-License-Identifier: LGPL-2.1-or-later
#include "figure.h"
#include "scene_run.h"

#include <gtest/gtest.h>

#include <cmath>
#include <numbers>

// What meets a plate at the axis may not jet along it: next to the axis the flow is nearly plane, so that what moves on
// the axis should be as fast as what moves five degrees off it, seen from the middle of the cloud when it arrives.

namespace
{
  using namespace whipple;

  struct Fastest
  {
    double axis = 0, off = 0; ///< cm/us along the axis
  };

  /// Fastest axial velocity near the front of what moves, on the axis and 3.8 to 6.2 degrees off it.
  Fastest
  fastest_at_front(const Simulation<2> &simulation, const double middle, const double depth)
  {
    const FlatMesh<2>  &mesh  = simulation.domain().view->mesh;
    const State<2>     &state = simulation.domain().state;
    std::vector<double> density(mesh.n_nodes, 0.);
    for (Index c = 0; c < mesh.n_owned; ++c)
      for (int k = 0; k < 4; ++k)
        {
          double mass = 0;
          for (const MaterialState &m : state.material)
            mass += m.mass[c];
          double &densest = density[mesh.cell_node[4 * c + k]];
          densest         = std::max(densest, mass / state.volume[c]);
        }
    constexpr double least = 3e-3; // g/cm^3, a thousandth of the solid: traces do not count
    const auto       angle = [&](const Index n) {
      return 180. / std::numbers::pi * std::atan2(state.position[0][n], state.position[1][n] - middle);
    };
    double front = -1e30;
    for (Index n = 0; n < mesh.n_nodes; ++n)
      if (density[n] > least && angle(n) < 6.2 && angle(n) >= 0)
        front = std::max(front, state.position[1][n]);
    Fastest fastest;
    for (Index n = 0; n < mesh.n_nodes; ++n)
      if (density[n] > least && state.position[1][n] > front - depth)
        {
          if (state.position[0][n] == 0)
            fastest.axis = std::max(fastest.axis, state.velocity[1][n]);
          else if (angle(n) > 3.8 && angle(n) < 6.2)
            fastest.off = std::max(fastest.off, state.velocity[1][n]);
        }
    return fastest;
  }
} // namespace

TEST(SceneAxis, CloudOnPlateDoesNotJet)
{
  const auto    simulation = verification::run("../tests/verification/cloud_on_plate.prm",
                                               {"Output/Fields interval = none"}, "cloud_on_plate");
  const Fastest fastest    = fastest_at_front(*simulation, -0.5, 0.15);
  ASSERT_GT(fastest.off, 0.1);
  figure::record("cloud on a plate: axial velocity at the axis over that 5 degrees off it", fastest.axis / fastest.off,
                 "0.97 to 1.03");
  EXPECT_LE(fastest.axis / fastest.off, 1.03);
  EXPECT_GE(fastest.axis / fastest.off, 0.97);
}

TEST(SceneAxis, PerforationDoesNotJet)
{
  const auto simulation =
      verification::run("whipple_shield.prm",
                        {"Mesh/Finest cell = 0.016 cm", "Stages/List = perforation", "Output/Fields interval = none"},
                        "axis_perforation");
  const Fastest fastest = fastest_at_front(*simulation, -0.16, 0.3);
  ASSERT_GT(fastest.off, 0.4);
  figure::record("perforated bumper: axial velocity at the axis over that 5 degrees off it", fastest.axis / fastest.off,
                 "0.97 to 1.03");
  EXPECT_LE(fastest.axis / fastest.off, 1.03);
  EXPECT_GE(fastest.axis / fastest.off, 0.97);
}
