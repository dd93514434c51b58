// SPDX-License-Identifier: LGPL-2.1-or-later
// Solid bodies that turn and fly: they stay whole, and keep what they must keep.
#include "../connected_pieces.h"
#include "../source_directory.h"
#include "metals.h"
#include "stability_run.h"

#include <cmath>

namespace
{
  using namespace whipple;
  using namespace whipple::stability;

  /// Sum of m (x v_y - y v_x) over the nodes.
  double
  angular_momentum(const State<2> &state)
  {
    double sum = 0;
    for (Index n = 0; n < state.n_nodes(); ++n)
      sum += state.node_mass[n] *
             (state.position[0][n] * state.velocity[1][n] - state.position[1][n] * state.velocity[0][n]);
    return sum;
  }

  double
  kinetic(const State<2> &state)
  {
    double sum = 0;
    for (Index n = 0; n < state.n_nodes(); ++n)
      sum += 0.5 * state.node_mass[n] * (std::pow(state.velocity[0][n], 2) + std::pow(state.velocity[1][n], 2));
    return sum;
  }

  /// A disc of aluminium, held together by the tension of its turning (1.4 GPa at its centre), exact at the start.
  void
  expect_disc(const std::string &mode, double cell, double turns)
  {
    char text[80];
    std::snprintf(text, sizeof text, "stressed disc, %g turn, cells of %g cm", turns, cell);
    Case                           table(text, "angular momentum is lost, the rim comes off, the mesh folds", mode);
    const std::vector<std::string> common{"Mesh/Finest cell = " + cm(cell), "Stages/turn/Mode = " + mode};
    const auto                     after = [&](double end, const char *folder) {
      std::vector<std::string> overrides = common;
      overrides.push_back("Stages/turn/End = " + with_unit(end, "us"));
      return run_file(source_directory() + "/prm/verification/rotation.prm", folder + mode, overrides);
    };
    const Outcome start = after(1e-6, "disc_start_"), outcome = after(20. * M_PI * turns, "disc_");
    expect_sound(table, outcome);
    // no strength, and cells with open void carry no tension: the rim comes off
    const double honest = turns < 1. ? 0.08 : 0.9;
    table.within_short("angular momentum / that at the start",
                       angular_momentum(outcome.state()) / angular_momentum(start.state()), 1., 0.01, honest);
    table.within_short("kinetic energy / that at the start", kinetic(outcome.state()) / kinetic(start.state()), 1.,
                       0.01, honest);
    table.at_most("pieces of more than 1e-6 of a cell", connected_pieces(outcome.mesh(), outcome.state(), 1e-6), 1);
  }

  TEST(QuickDisc, EulerianQuarterTurn)
  {
    expect_disc("eulerian", 0.1, 0.25);
  }
  TEST(Disc, EulerianOneTurn)
  {
    expect_disc("eulerian", 0.08, 1.);
  }

  /// A jet, three cells across, flies four of its lengths over an adaptive mesh.
  TEST(QuickJet, StaysOnePiece)
  {
    Case      table("jet of three cells across flies four lengths", "the jet breaks up into drops", "eulerian");
    SceneText scene = box("axisymmetric", 0, -0.4, 0.32, 2.4, 0.02, "transmitting");
    scene.set("Mesh/Levels", "2")
        .set("Mesh/Refinement", "adaptive")
        .set("Effects/List", "strength, voids")
        .add("Materials", "metal", shield_aluminium());
    scene.add("Bodies", "jet", block(0, -0.31, 0.031, 0.113, "metal", 0., 0.7))
        .add("Stages", "flight", {{"Mode", "eulerian"}, {"End", "2.5 us"}});
    const Outcome outcome = run(scene, "jet");
    expect_sound_impact(table, outcome);
    table.at_most("pieces", connected_pieces(outcome.mesh(), outcome.state(), 0.), 1);
    table.at_most("fastest node / velocity of the jet, less 1", outcome.fastest() / 0.7 - 1., 1e-12);
    table.at_most("largest specific energy / kinetic", outcome.greatest(&MaterialState::energy) / (0.5 * 0.49), 1e-8);
  }

  /// A jet that is drawn out: each slice faster than the one behind it, by 10 % from end to end.
  TEST(QuickJet, DrawnOutStaysOnePiece)
  {
    Case      table("jet drawn out to 1.4 of its length", "it breaks up where the mesh lines are", "eulerian");
    SceneText scene = box("axisymmetric", 0, -0.4, 0.24, 2.0, 0.02, "transmitting");
    scene.set("Effects/List", "strength")
        .add("Materials", "metal", {{"Library", "copper OFHC"}, {"Strength", "perfectly plastic"}});
    for (int i = 0; i < 20; ++i)
      scene.add("Bodies", "s" + std::to_string(i),
                block(0, -0.2 + 0.02 * i, 0.06, -0.18 + 0.02 * i, "metal", 0., 0.6 + 0.004 * i));
    scene.add("Stages", "flight", {{"Mode", "eulerian"}, {"End", "2 us"}});
    const Outcome outcome = run(scene, "jet_drawn_out");
    expect_sound_impact(table, outcome);
    table.at_most("pieces of more than a hundredth of a cell", connected_pieces(outcome.mesh(), outcome.state(), 0.01),
                  1);
    table.at_most("fastest node / velocity of the tip, less 1", outcome.fastest() / 0.676 - 1., 1e-9);
  }
} // namespace
