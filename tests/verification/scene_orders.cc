// SPDX-License-Identifier: LGPL-2.1-or-later
// Orders of convergence against exact solutions, from the error norms that runs report (summary.json, `errors`).
#include "../figure.h"
#include "scene_run.h"

#include <gtest/gtest.h>

#include <cmath>
#include <string>
#include <vector>

namespace
{
  using namespace whipple;

  /// A way to run a scene, and the orders between cells of size `coarse` and `coarse` / 2 that must hold.
  struct Case
  {
    std::string              scene;     ///< under prm/verification
    std::string              way;       ///< for the table
    std::vector<std::string> overrides; ///< all but the cell size
    double                   coarse;    ///< cm
    double                   required;  ///< least order of L1 of density and velocity
  };

  std::map<std::string, summary::Error>
  errors(const Case &c, double cell)
  {
    std::vector<std::string> overrides = c.overrides;
    overrides.push_back("Mesh/Finest cell = " + std::to_string(cell) + " cm");
    overrides.push_back("Output/Fields interval = none");
    return verification::run("verification/" + c.scene + ".prm", overrides, "order_" + c.scene)->summary().errors;
  }

  void
  expect_orders(const Case &c)
  {
    const auto coarse = errors(c, c.coarse), fine = errors(c, 0.5 * c.coarse);
    for (const char *field : {"density", "velocity"})
      {
        const double order = std::log2(*coarse.at(field).l1 / *fine.at(field).l1);
        char         required[16];
        std::snprintf(required, sizeof required, ">= %.2f", c.required);
        figure::record(c.scene + ", " + c.way + ": order of the " + field + " in L1", order, required);
        EXPECT_GE(order, c.required) << c.scene << ", " << c.way << ", " << field << ": " << *coarse.at(field).l1
                                     << " to " << *fine.at(field).l1;
      }
  }

  const std::string vortex_box = "Mesh/Region = -2.5 cm, -2.5 cm, 2.5 cm, 2.5 cm",
                    wave_box   = "Mesh/Region = 0 cm, 0 cm, 0.5 cm, 1 cm",
                    sound_box  = "Mesh/Region = 0 cm, 0 cm, 0.5 cm, 0.5 cm";
  const std::string region = "Mesh/Refinement = region", axisymmetric = "Geometry/Symmetry = axisymmetric";

  // Second order where the flow is smooth. L2 falls short in places: doc/limitations.md, "Orders".
  TEST(SceneOrders, VortexEulerian)
  {
    expect_orders({"isentropic_vortex", "Eulerian, uniform", {}, 0.125, 1.9});
  }
  TEST(SceneOrders, VortexEulerianHangingNodes)
  {
    expect_orders({"isentropic_vortex", "Eulerian, hanging nodes", {region, vortex_box}, 0.125, 1.9});
  }
  TEST(SceneOrders, VortexLagrangian)
  {
    expect_orders({"isentropic_vortex", "Lagrangian, uniform", {"Stages/turn/Mode = lagrangian"}, 0.125, 1.9});
  }
  TEST(SceneOrders, EntropyWaveAxisymmetric)
  {
    expect_orders({"entropy_wave", "Eulerian, axisymmetric, uniform", {axisymmetric}, 0.025, 1.9});
  }
  TEST(SceneOrders, EntropyWaveAxisymmetricHangingNodes)
  {
    expect_orders(
        {"entropy_wave", "Eulerian, axisymmetric, hanging nodes", {axisymmetric, region, wave_box}, 0.025, 1.9});
  }
  TEST(SceneOrders, SoundWaveAxisymmetricLagrangian)
  {
    expect_orders({"sound_wave",
                   "Lagrangian, axisymmetric, uniform",
                   {axisymmetric, "Stages/swing/Mode = lagrangian"},
                   0.025,
                   1.9});
  }
  TEST(SceneOrders, SoundWaveAxisymmetricLagrangianHangingNodes)
  {
    expect_orders({"sound_wave",
                   "Lagrangian, axisymmetric, hanging nodes",
                   {axisymmetric, "Stages/swing/Mode = lagrangian", region, sound_box},
                   0.025,
                   1.9});
  }

  // First order where it shocks.
  TEST(SceneOrders, NohPlanar)
  {
    for (const std::string mode : {"eulerian", "lagrangian"})
      expect_orders({"noh_planar", mode, {"Stages/infall/Mode = " + mode}, 0.01, 0.9});
  }
  TEST(SceneOrders, AluminiumImpact)
  {
    for (const std::string mode : {"eulerian", "lagrangian"})
      expect_orders({"aluminium_impact", mode, {"Stages/impact/Mode = " + mode}, 0.02, 0.9});
  }
  TEST(SceneOrders, Saltzman)
  {
    expect_orders({"saltzman", "Lagrangian", {}, 0.01, 0.9});
  }
} // namespace
