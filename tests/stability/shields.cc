// SPDX-License-Identifier: LGPL-2.1-or-later
// Shields of one to eight plates whose stages are derived from the bodies, over spacing, thickness and speed.
#include "../source_directory.h"
#include "metals.h"
#include "stability_run.h"

#include <whipple/ledger/ledger.h>

#include <cstdio>
#include <string>
#include <variant>

namespace
{
  using namespace whipple;
  using namespace whipple::stability;

  constexpr double diameter = 0.32, wall = 0.08, cell = 0.032; // cm

  struct Shield
  {
    const char *name;
    int         plates;    ///< with the wall
    double      thickness; ///< of all but the wall, cm
    double      spacing;   ///< rear face to front face, cm
    double      speed;     ///< km/s
  };

  void
  PrintTo(const Shield &shield, std::ostream *text)
  {
    *text << shield.name;
  }

  SceneText
  scene_of(const Shield &shield)
  {
    const double depth = (shield.plates - 1) * (shield.thickness + shield.spacing) + wall;
    // whole coarse cells of the tree
    const double block = 8 * cell, height = block * std::ceil((depth + 4. * diameter) / block);
    SceneText    scene = box("axisymmetric", 0, -2 * block, block * std::ceil(1. + 0.3 * depth / block + 1.5 / block),
                             height + block, cell, "transmitting");
    scene.set("Mesh/Levels", "3").set("Mesh/Refinement", "adaptive");
    Entries aluminium = shield_aluminium();
    aluminium.push_back({"Fragments", "grady-kipp"});
    scene.set("Effects/List", "strength, voids, body tags, fragment size").add("Materials", "metal", aluminium);
    scene.add("Bodies", "sphere", sphere(0, -0.5 * diameter, diameter, "metal", 0., 0.1 * shield.speed));
    for (int k = 0; k < shield.plates; ++k)
      scene.add(
          "Bodies", k + 1 < shield.plates ? "plate " + std::to_string(k + 1) : "wall",
          plate(k * (shield.thickness + shield.spacing), k + 1 < shield.plates ? shield.thickness : wall, "metal"));
    scene.set("Stages/List", "automatic").set("Stages/impact/End", "for 4 us").set("Output/Fields interval", "none");
    return scene;
  }

  bool
  says_all(const summary::Summary &summary, const Shield &shield)
  {
    for (int k = 0; k < shield.plates; ++k)
      {
        const auto plate = summary.results.find(k + 1 < shield.plates ? "plate " + std::to_string(k + 1) : "wall");
        if (plate == summary.results.end() || !plate->second.contains("perforated"))
          return false;
      }
    return true;
  }

  /// Every stage is there and has ended by itself, the ledger is closed with all that was dropped, kinetic energy never
  /// grows.
  void
  expect_chain(const Shield &shield)
  {
    char text[160];
    std::snprintf(text, sizeof text, "automatic chain: %d plates of %g cm, %g cm apart, %g km/s, cells of %g cm",
                  shield.plates, shield.thickness, shield.spacing, shield.speed, cell);
    Case          table(text, "a stage never ends, a plate is skipped, the ledger opens over the stages",
                        "eulerian and lagrangian in turn");
    const Outcome outcome = run(scene_of(shield), std::string("shield_") + shield.name);
    expect_sound_impact(table, outcome);
    const summary::Summary &summary = outcome.summary();
    // a plate that holds ends the chain: that is a result
    const bool all = summary.stages.size() == 2u * shield.plates - 1;
    table.holds("comes to every plate, or says which has held", all || summary.reason.has_value(),
                all ? std::to_string(summary.stages.size()) + " stages" : summary.reason.value_or("neither"));
    table.holds("says of every plate whether it is perforated", says_all(summary, shield), "yes");
    table.report("end, us", outcome.summary().stages.back().end_us);
    table.report("steps", outcome.steps());
  }

  const auto shield_name = [](const auto &info) { return std::string(info.param.name); };

  class QuickShields : public testing::TestWithParam<Shield>
  {
  };
  TEST_P(QuickShields, FinishAndClose)
  {
    expect_chain(GetParam());
  }
  INSTANTIATE_TEST_SUITE_P(Few, QuickShields,
                           testing::Values(Shield{"two_plates", 2, 0.05, 2.5, 6.5},
                                           Shield{"three_thin_fast", 3, 0.005, 0.5, 12.}),
                           shield_name);

  class Shields : public testing::TestWithParam<Shield>
  {
  };
  TEST_P(Shields, FinishAndClose)
  {
    expect_chain(GetParam());
  }
  INSTANTIATE_TEST_SUITE_P(
      Many, Shields,
      testing::Values(Shield{"one_plate", 1, 0.08, 1., 6.5}, Shield{"two_close_slow", 2, 0.1, 0.5, 3.},
                      Shield{"two_far", 2, 0.1, 10., 6.5}, Shield{"two_thin_slow", 2, 0.005, 5., 3.},
                      Shield{"three_thick_fast", 3, 0.1, 2.5, 12.}, Shield{"four_slow", 4, 0.05, 1., 3.},
                      Shield{"five", 5, 0.0102, 2.54, 6.5}, Shield{"eight_close", 8, 0.0102, 0.5, 6.5},
                      Shield{"eight_fast", 8, 0.02, 2., 12.}),
      shield_name);

  /// The published case at 0.3 km/s: the bumper is dished and holds, the wall is not reached.
  TEST(Shields, ADishedBumperHolds)
  {
    Case          table("published case at 0.3 km/s, cells of 0.032 cm", "a bent plate counts as perforated",
                        "eulerian, lagrangian");
    const Outcome outcome = run_file(source_directory() + "/prm/whipple_shield.prm", "dished",
                                     {"Mesh/Finest cell = 0.032 cm", "Mesh/Levels = 2", "Output/Fields interval = none",
                                      "Bodies/sphere/Velocity = 0 km/s, 0.3 km/s", "Stages/perforation/End = 20 us"});
    expect_sound_impact(table, outcome);
    const auto &results = outcome.summary().results;
    const auto  figure  = [&](const char *plate, const char *quantity) {
      return std::get<double>(results.at(plate).at(quantity));
    };
    for (const char *plate : {"bumper", "wall"})
      {
        table.holds(std::string(plate) + " holds", !std::get<bool>(results.at(plate).at("perforated")), "yes");
        table.at_most(std::string("hole of the ") + plate + ", cm", figure(plate, "hole_diameter_cm"), 0.);
      }
    table.above("dish of the bumper behind its rear plane, cm", figure("bumper", "rear_bulge_cm"), 0.05);
    table.holds("says that nothing flies on", outcome.summary().reason.has_value(),
                outcome.summary().reason.value_or("no"));
  }

  /// The published case with the hand-over 30 % earlier and later: the bumper is followed until its hole has settled,
  /// so that the hole does not hang on it; nor does the front, nor the verdict.
  TEST(Shields, HandOverEarlierAndLater)
  {
    Case       table("published case, hand-over at 0.65, 0.92, 1.2 us, cells of 0.016 cm",
                     "hole, front or verdict hang on when the debris is handed over", "eulerian, lagrangian, eulerian");
    const auto shield = [](const char *end) {
      return run_file(source_directory() + "/prm/whipple_shield.prm", std::string("handover_") + end,
                      {"Mesh/Finest cell = 0.016 cm", "Output/Fields interval = none",
                       "Stages/perforation/Plates measured = settled",
                       std::string("Stages/perforation/End = ") + end + " us", "Stages/wall/End = for 1 us"});
    };
    const Outcome middle = shield("0.92");
    expect_sound_impact(table, middle);
    const auto figure = [](const Outcome &outcome, const char *place, const char *quantity) {
      return std::get<double>(outcome.summary().results.at(place).at(quantity));
    };
    const auto perforated = [](const Outcome &outcome) {
      return std::get<bool>(outcome.summary().results.at("wall").at("perforated"));
    };
    for (const char *end : {"0.65", "1.2"})
      {
        const Outcome     other = shield(end);
        const std::string at    = std::string(" at ") + end + " us";
        table.within("hole" + at + ", cm", figure(other, "bumper", "hole_diameter_cm"),
                     figure(middle, "bumper", "hole_diameter_cm"), 0.02);
        table.within("velocity of the leading edge" + at + ", cm/us",
                     figure(other, "debris", "leading_edge_velocity_cm_per_us"),
                     figure(middle, "debris", "leading_edge_velocity_cm_per_us"), 0.02);
        table.holds("the same verdict on the wall" + at, perforated(other) == perforated(middle), "yes");
      }
  }
} // namespace
