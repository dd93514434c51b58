// SPDX-License-Identifier: LGPL-2.1-or-later
// Material that expands into nothing, and material that hardly fills the cells it flies through.
#include "metals.h"
#include "stability_run.h"

#include <whipple/exact/isentrope.h>

#include <cmath>

namespace
{
  using namespace whipple;
  using namespace whipple::stability;

  /// Foremost point along axis 1 of all cells that hold more than a share of their volume of material.
  double
  foremost(const Outcome &outcome, double share)
  {
    double z = -1e300;
    for (Index c = 0; c < outcome.mesh().n_owned; ++c)
      {
        double volume = 0;
        for (const MaterialState &m : outcome.state().material)
          volume += m.volume[c];
        if (volume > share * outcome.state().volume[c])
          for (int k = 0; k < 4; ++k)
            z = std::max(z, outcome.state().position[1][outcome.mesh().cell_node[4 * c + k]]);
      }
    return z;
  }

  class QuickVacuum : public testing::TestWithParam<const char *>
  {
  };

  /// Gas of exponent 1.4, density 1, pressure 1 on [0, 0.5] is set free: the front flies with 2c/(gamma - 1) (L. D.
  /// Landau, E. M. Lifshitz, Fluid Mechanics, section 99); rho = rho0 (1 - (gamma-1)/2 w/c)^(2/(gamma-1)), w =
  /// 2/(gamma+1) (c + x/t).
  TEST_P(QuickVacuum, GasNotFasterThanItsEscapeSpeed)
  {
    const std::string mode = GetParam();
    const double      cell = 0.005, end = 0.1, edge = 0.5, k = 1.4, c = std::sqrt(1.4), escape = 2. * c / (k - 1.);
    Case      table("gas set free into vacuum, cells of 0.005 cm", "the front runs ahead of the escape speed", mode);
    SceneText scene = box("planar", 0, 0, 0.01, 1.5, cell, "transmitting");
    scene.set("Geometry/Right", "reflecting").set("Geometry/Bottom", "reflecting");
    scene.add("Materials", "gas",
              {{"Equation of state", "ideal gas"}, {"Density", "1 g/cm^3"}, {"Adiabatic exponent", "1.4"}});
    Entries gas = block(0, 0, 0.01, edge, "gas");
    gas.push_back({"Pressure", "1 Mbar"});
    scene.add("Bodies", "gas", gas).add("Stages", "free", {{"Mode", mode}, {"End", with_unit(end, "us")}});
    const Outcome outcome = run(scene, "vacuum_gas_" + mode);
    expect_sound(table, outcome);
    table.above("smallest density, g/cm^3", outcome.smallest(&MaterialState::density), 0.);
    table.above("smallest energy, Mbar cm^3/g", outcome.smallest(&MaterialState::energy), 0.);
    table.at_most_short("fastest node / escape speed", outcome.fastest() / escape, 1., 1.12);
    table.at_most("front beyond the exact one, cells", (foremost(outcome, 0.) - edge - escape * end) / cell, 1.);
    double error = 0, norm = 0;
    for (const Cell &s : outcome.cells())
      {
        // exact mean over the cell by ten points
        double mean = 0;
        for (int i = 0; i < 10; ++i)
          {
            const double ray = (s.x[1] + ((i + 0.5) / 10. - 0.5) * s.extent - edge) / end;
            const double w   = std::clamp(2. / (k + 1.) * (c + ray), 0., escape);
            mean += 0.1 * std::pow(1. - 0.5 * (k - 1.) * w / c, 2. / (k - 1.));
          }
        error += std::abs(s.density - mean) * s.volume;
        norm += mean * s.volume;
      }
    table.report("relative L1 error of the density", error / norm);
  }

  /// Hot aluminium of 0.5 Mbar is set free: it is released to zero pressure along its isentrope and then flies on.
  TEST_P(QuickVacuum, MetalNotFasterThanItsRelease)
  {
    const std::string mode = GetParam();
    const double      cell = 0.005, end = 0.3, edge = 0.5;
    Case table("hot aluminium set free into vacuum", "the front runs ahead of the release, energy below the cold curve",
               mode);
    SceneText scene = box("planar", 0, 0, 0.01, 1.2, cell, "transmitting");
    scene.set("Geometry/Right", "reflecting").set("Geometry/Bottom", "reflecting").set("Effects/List", "voids");
    scene.add("Materials", "metal",
              {{"Library", "aluminium 2024-T4"}, {"Void law", "equilibrium"}, {"Spall strength", "1.2 GPa"}});
    Entries body = block(0, 0, 0.01, edge, "metal");
    body.push_back({"Pressure", "0.5 Mbar"});
    scene.add("Bodies", "metal", body).add("Stages", "free", {{"Mode", mode}, {"End", with_unit(end, "us")}});
    const Outcome outcome = run(scene, "vacuum_metal_" + mode);
    expect_sound(table, outcome);
    const Problem<2>       read = read_problem<2>("stability_output/vacuum_metal_" + mode + "/scene.prm");
    const auto             eos  = read.materials[0].model.eos;
    const exact::Isentrope isentrope(
        eos, exact::fluid_point(*eos, read.scene.bodies[0].density, read.scene.bodies[0].energy));
    const double release = isentrope.at_pressure(0.).speed;
    table.at_most_short("fastest node / release velocity", outcome.fastest() / release, 1.01, 1.4);
    table.at_most_short("front beyond the exact one, cells", (foremost(outcome, 0.) - edge - release * end) / cell, 1.,
                        7.);
    table.above("smallest energy, Mbar cm^3/g", outcome.smallest(&MaterialState::energy), 0.);
  }
  INSTANTIATE_TEST_SUITE_P(Modes, QuickVacuum, testing::Values("eulerian", "lagrangian"),
                           [](const auto &info) { return std::string(info.param); });

  /// A block whose lower edge reaches 10^-k of a cell beyond a line of the mesh flies through vacuum.
  TEST(QuickNearVoid, SliversOfACellFlyWithTheBody)
  {
    Case   table("block in flight, 1e-1 ... 1e-12 of a cell beyond a mesh line",
                 "a sliver gets a velocity or a time step of its own", "eulerian");
    double fastest = 0, slowest_step = 1, heat = 0, closure = 0;
    bool   finish = true;
    for (const int k : {1, 2, 4, 6, 8, 10, 12})
      for (const double side : {1., -1.})
        {
          SceneText scene = box("planar", 0, 0, 0.2, 0.6, 0.02, "transmitting");
          scene.set("Effects/List", "strength, voids").add("Materials", "metal", shield_aluminium());
          scene.add("Bodies", "block",
                    block(0, 0.1 - side * 0.02 * std::pow(10., -k), 0.1 + side * 0.02 * std::pow(10., -k), 0.2, "metal",
                          0., 0.5));
          scene.add("Stages", "flight", {{"Mode", "eulerian"}, {"End", "0.5 us"}});
          const Outcome outcome = run(scene, "near_void");
          finish                = finish && !outcome.stopped;
          fastest               = std::max(fastest, outcome.fastest() / 0.5);
          slowest_step          = std::min(slowest_step, outcome.smallest_step_over_median());
          heat                  = std::max(heat, outcome.greatest(&MaterialState::energy) / 0.125);
          closure               = std::max(closure, outcome.closure());
        }
    table.holds("finishes", finish, finish ? "yes" : "no");
    table.at_most("closure of mass, momentum, energy", closure, 1e-12);
    table.at_most_short("fastest node / velocity of the block, less 1", fastest - 1., 1e-12, 1e-9);
    table.at_least("smallest time step / median", slowest_step, 0.05);
    table.at_most("largest specific energy / kinetic", heat, 1e-8);
  }

  /// Strips of a bar, each faster than the one below, open voids up to phi = 0.9999 and beyond.
  TEST(QuickNearVoid, FreeExpansionToAlmostNothing)
  {
    Case table("bar that is stretched 1e4 times", "a velocity above all donors', a time step that collapses, phi = 1",
               "lagrangian");
    SceneText scene = box("planar", 0, 0, 0.04, 0.4, 0.02, "transmitting");
    scene.set("Geometry/Right", "reflecting").set("Effects/List", "voids");
    scene.add("Materials", "metal",
              {{"Library", "aluminium 2024-T4"}, {"Void law", "equilibrium"}, {"Spall strength", "0 GPa"}});
    for (int i = 0; i < 10; ++i)
      scene.add("Bodies", "strip" + std::to_string(i),
                block(0, 0.1 + 0.02 * i, 0.04, 0.12 + 0.02 * i, "metal", 0., 0.2 * i));
    scene.add("Stages", "flight", {{"Mode", "lagrangian"}, {"End", "1500 us"}});
    const Outcome outcome = run(scene, "free_expansion");
    expect_sound_impact(table, outcome);
    table.at_most("fastest node / fastest strip, less 1", outcome.fastest() / 1.8 - 1., 1e-12);
    table.at_least("largest phi", outcome.greatest(&MaterialState::void_fraction), 0.9998);
    table.holds("phi < 1", outcome.greatest(&MaterialState::void_fraction) < 1., "yes");
    table.at_least("smallest time step / median", outcome.smallest_step_over_median(), 0.05);
    table.report("steps", outcome.steps());
  }

  /// Shares of 1 ... 1e-5 of a cell side by side (a scene may say no less; smaller ones come out of the remap): bodies
  /// of one column each, thinner and thinner.
  TEST(QuickNearVoid, TracesDoNotSetTheStep)
  {
    Case      table("blocks filling 1 ... 1e-5 of their cells hit a plate",
                    "a trace is heated without bound and sets the time step", "eulerian");
    SceneText scene = box("planar", 0, -0.2, 0.26, 0.2, 0.02, "transmitting");
    scene.set("Effects/List", "strength, voids")
        .add("Materials", "metal", shield_aluminium())
        .add("Materials", "other", metal("copper OFHC"));
    for (int k = 0; k <= 5; ++k)
      scene.add("Bodies", "b" + std::to_string(k),
                block(0.02 * k, -0.02, 0.02 * (k + std::pow(10., -k)), 0., k % 2 ? "metal" : "other", 0., 0.5));
    scene.add("Bodies", "plate", plate(0., 0.06, "metal"));
    scene.add("Stages", "impact", {{"Mode", "eulerian"}, {"End", "0.4 us"}});
    const Outcome outcome = run(scene, "traces");
    expect_sound_impact(table, outcome);
    table.at_least("smallest time step / median", outcome.smallest_step_over_median(), 0.05);
    table.at_most("largest specific energy / kinetic of the impact", outcome.greatest(&MaterialState::energy) / 0.125,
                  1.);
    table.at_most("fastest node / velocity of the blocks", outcome.fastest() / 0.5, 1.1);
  }
} // namespace
