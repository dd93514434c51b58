// SPDX-License-Identifier: LGPL-2.1-or-later
// Moving meshes that overlap, fold, or are laid down and taken up again and again.
#include "../source_directory.h"
#include "field_files.h"
#include "metals.h"
#include "stability_run.h"

#include <algorithm>
#include <cmath>
#include <ostream>

namespace
{
  using namespace whipple;
  using namespace whipple::stability;

  /// Stopping is an answer, too, if it says why in more than a few words.
  void
  expect_bounded(Case &table, const Outcome &outcome, double honest = 1e-9)
  {
    table.holds("ends, or stops in clear words", !outcome.stopped || outcome.stopped->size() > 40,
                outcome.stopped ? "stopped: " + outcome.stopped->substr(0, 120) : "ends");
    table.at_most("closure of mass, momentum, energy", outcome.closure(), 1e-12);
    // bodies that meet in a cell bring heat, which may turn into motion again
    const auto &brought = outcome.ledger().introduced();
    table.at_most_short(
        "largest kinetic energy / energy that the bodies brought, less 1",
        outcome.largest("kinetic energy") / (brought.kinetic_energy + std::max(0., brought.internal_energy)) - 1., 1e-9,
        honest);
  }

  /// Two blocks that fly one behind the other as fragments: the faster one flies into the slower, then both are laid
  /// down.
  class QuickOverlap : public testing::TestWithParam<std::tuple<const char *, const char *>>
  {
  };
  TEST_P(QuickOverlap, CompressionIsPaidFor)
  {
    const auto &[cohesion, representation] = GetParam();
    Case      table(std::string("block overtakes block, laid down as ") + representation,
                    "pieces overlap, solid is squeezed for nothing, kinetic energy appears",
                    std::string("lagrangian ") + cohesion + ", eulerian");
    SceneText scene = box("planar", 0, 0, 0.2, 2, 0.02, "transmitting");
    scene.set("Geometry/Left", "transmitting")
        .set("Effects/List", "strength, voids, body tags")
        .add("Materials", "metal", shield_aluminium());
    scene.add("Bodies", "fast", block(0.04, 0.2, 0.16, 0.32, "metal", 0., 0.06))
        .add("Bodies", "slow", block(0.06, 0.36, 0.14, 0.5, "metal", 0., 0.03));
    scene.add("Stages", "flight", {{"Mode", "lagrangian"}, {"Cohesion", cohesion}, {"End", "8 us"}});
    scene.add("Stages", "land", {{"Mode", "eulerian"}, {"Representation", representation}, {"End", "for 0.5 us"}});
    const Outcome outcome = run(scene, std::string("overlap_") + cohesion + "_" + representation);
    expect_bounded(table, outcome);
    double internal = 0;
    for (const double e : outcome.statistics["internal energy"])
      internal = std::min(internal, e);
    table.at_least("smallest internal energy in all / kinetic energy brought",
                   internal / outcome.ledger().introduced().kinetic_energy, -1e-9);
  }
  INSTANTIATE_TEST_SUITE_P(All, QuickOverlap,
                           testing::Combine(testing::Values("fragments", "graded"),
                                            testing::Values("distended", "packages")),
                           [](const auto &info) {
                             return std::string(std::get<0>(info.param)) + "_" + std::get<1>(info.param);
                           });

  struct Shear
  {
    const char *name, *cohesion, *effects;
    double      cell;
  };
  void
  PrintTo(const Shear &shear, std::ostream *text)
  {
    *text << shear.name;
  }

  /// Two halves of a closed box slide past one another until every element between them has turned over.
  void
  expect_shear(const Shear &shear)
  {
    Case      table(std::string("shear past inversion, ") + shear.effects,
                    "the mesh folds and trades internal for kinetic energy without bound",
                    std::string("lagrangian ") + shear.cohesion);
    SceneText scene = box("planar", 0, 0, 1, 1, shear.cell, "reflecting");
    scene.set("Effects/List", shear.effects).add("Materials", "metal", shield_aluminium());
    scene.add("Bodies", "up", block(0, 0, 0.5, 1, "metal", 0., 0.3))
        .add("Bodies", "down", block(0.5, 0, 1, 1, "metal", 0., -0.3));
    scene.add("Stages", "shear", {{"Mode", "lagrangian"}, {"Cohesion", shear.cohesion}, {"End", "6 us"}});
    const Outcome outcome = run(scene, std::string("shear_") + shear.name);
    expect_bounded(table, outcome);
    double internal = 0;
    for (const double e : outcome.statistics["internal energy"])
      internal = std::min(internal, e);
    table.at_least("smallest internal energy in all / kinetic energy brought",
                   internal / outcome.ledger().introduced().kinetic_energy, -1e-9);
    table.report("steps", outcome.steps());
  }

  class QuickShear : public testing::TestWithParam<Shear>
  {
  };
  TEST_P(QuickShear, NoGrowthOfKineticEnergy)
  {
    expect_shear(GetParam());
  }
  INSTANTIATE_TEST_SUITE_P(Coarse, QuickShear,
                           testing::Values(Shear{"bonded", "bonded", "voids", 0.1},
                                           Shear{"fragments", "fragments", "voids", 0.1},
                                           Shear{"graded_strength", "graded", "strength, voids", 0.1}),
                           [](const auto &info) { return std::string(info.param.name); });
  class Shears : public testing::TestWithParam<Shear>
  {
  };
  TEST_P(Shears, NoGrowthOfKineticEnergy)
  {
    expect_shear(GetParam());
  }
  INSTANTIATE_TEST_SUITE_P(Fine, Shears,
                           testing::Values(Shear{"bonded_strength", "bonded", "strength, voids", 0.05},
                                           Shear{"fragments_strength", "fragments", "strength, voids", 0.05},
                                           Shear{"graded", "graded", "voids", 0.05}),
                           [](const auto &info) { return std::string(info.param.name); });

  /// Vortices of gas, bodies of one cell each with the velocity of Taylor and Green, u = sin(pi x) cos(pi y), v =
  /// -cos(pi x) sin(pi y), until the mesh has turned over.
  class TaylorGreen : public testing::TestWithParam<const char *>
  {
  };
  TEST_P(TaylorGreen, UntilTheMeshTurnsOver)
  {
    const std::string cohesion = GetParam();
    const int         n        = 10;
    const double      cell = 1. / n, amplitude = 0.2;
    Case              table("Taylor-Green vortex in aluminium, one body a cell", "the mesh folds, kinetic energy grows",
                            "lagrangian " + cohesion);
    SceneText         scene = box("planar", 0, 0, 1, 1, cell, "reflecting");
    scene.set("Effects/List", "strength, voids").add("Materials", "metal", shield_aluminium());
    for (int j = 0; j < n; ++j)
      for (int i = 0; i < n; ++i)
        {
          const double x = M_PI * (i + 0.5) * cell, y = M_PI * (j + 0.5) * cell;
          scene.add("Bodies", "b" + std::to_string(i) + "-" + std::to_string(j),
                    block(cell * i, cell * j, cell * (i + 1), cell * (j + 1), "metal",
                          amplitude * std::sin(x) * std::cos(y), -amplitude * std::cos(x) * std::sin(y)));
        }
    scene.add("Stages", "turn", {{"Mode", "lagrangian"}, {"Cohesion", cohesion}, {"End", "8 us"}});
    // fragments may gain 1e-3; as measured they gain nothing (doc/stability.md)
    expect_bounded(table, run(scene, "taylor_green_" + cohesion), cohesion == "fragments" ? 1e-3 : 1e-9);
  }
  INSTANTIATE_TEST_SUITE_P(Cohesions, TaylorGreen, testing::Values("bonded", "graded", "fragments"),
                           [](const auto &info) { return std::string(info.param); });

  /// A ring that opens and flies, handed over from one mesh to the other forty times.
  class RoundTrips : public testing::TestWithParam<std::tuple<const char *, const char *>>
  {
  };
  TEST_P(RoundTrips, TwentyThereAndBack)
  {
    const auto &[cohesion, representation] = GetParam();
    Case      table(std::string("expanding ring, 20 round trips, laid down as ") + representation,
                    "mass, momentum or energy lost on the way; the ring spreads",
                    std::string("eulerian, lagrangian ") + cohesion + ", 20 times");
    const int pairs = 20;
    SceneText scene = box("axisymmetric", 0, -0.2, 1.6, 1.6, 0.02, "transmitting");
    scene.set("Effects/List", "strength, voids").add("Materials", "metal", shield_aluminium());
    scene.add("Bodies", "ring", block(0.3, 0., 0.4, 0.1, "metal", 0.3, 0.4));
    for (int i = 0; i < pairs; ++i)
      {
        Entries eulerian{{"Mode", "eulerian"}, {"End", "for 0.05 us"}};
        if (i > 0)
          eulerian.push_back({"Representation", representation});
        scene.add("Stages", "e" + std::to_string(i), eulerian);
        scene.add("Stages", "l" + std::to_string(i),
                  {{"Mode", "lagrangian"},
                   {"Cohesion", cohesion},
                   {"Void cutoff", "100 %"},
                   {"Minimum axial velocity", "0 %"},
                   {"End", "for 0.05 us"}});
      }
    const Outcome outcome = run(scene, std::string("round_trips_") + cohesion + "_" + representation);
    table.holds("finishes", !outcome.stopped, outcome.stopped ? "stopped: " + outcome.stopped->substr(0, 120) : "yes");
    table.at_most("closure of mass, momentum, energy", outcome.closure(), 1e-11);
    table.at_most("largest kinetic energy / that of the ring, less 1", outcome.kinetic_growth() - 1., 1e-9);
    double dropped = 0;
    for (const auto &[cause, booking] : outcome.ledger().bookings().by_cause())
      dropped += booking.dropped ? booking.dropped->mass : 0.;
    table.report("mass dropped / mass", dropped / outcome.ledger().introduced().mass);
    double mass = 0, mean = 0, square = 0;
    for (const Cell &s : outcome.cells())
      {
        mass += s.mass;
        mean += s.mass * s.x[1];
        square += s.mass * s.x[1] * s.x[1];
      }
    table.report("width along axis 1 (standard deviation) / that at the start",
                 std::sqrt(std::max(0., square / mass - mean * mean / mass / mass)) / (0.1 / std::sqrt(12.)));
  }
  INSTANTIATE_TEST_SUITE_P(All, RoundTrips,
                           testing::Values(std::tuple("bonded", "distended"), std::tuple("fragments", "distended"),
                                           std::tuple("fragments", "packages")),
                           [](const auto &info) {
                             return std::string(std::get<0>(info.param)) + "_" + std::get<1>(info.param);
                           });

  /// The published case on cells of 0.032 cm, far below the speed it was made for.
  void
  expect_chain(double speed, double sideways)
  {
    char text[80], folder[40];
    std::snprintf(text, sizeof text, "published case at %g km/s%s, cells of 0.032 cm", speed,
                  sideways > 0 ? ", oblique, planar" : "");
    std::snprintf(folder, sizeof folder, "chain_%g%s", speed, sideways > 0 ? "_oblique" : "");
    Case table(text, "pieces overlap, kinetic energy from nowhere, pressures no impact of this speed can make",
               "eulerian, lagrangian fragments, eulerian");
    const std::string through = with_unit(std::min(6. / speed, 12.), "us"),
                      flight  = with_unit(std::min(20. / speed, 40.), "us");
    std::vector<std::string> overrides{"Mesh/Finest cell = 0.032 cm",
                                       "Mesh/Levels = 2",
                                       "Bodies/sphere/Velocity = " + velocity(0.1 * sideways, 0.1 * speed),
                                       "Stages/perforation/End = " + through,
                                       "Stages/debris/End = for " + flight,
                                       "Stages/debris/Minimum axial velocity = 0 %",
                                       "Stages/debris/Debris behind = none",
                                       "Stages/wall/End = for 1 us",
                                       "Output/Fields interval = " + with_unit(0.2 / speed, "us")};
    if (sideways > 0)
      for (const char *more :
           {"Geometry/Symmetry = planar", "Geometry/Left = transmitting", "Bodies/sphere/Center = 1 cm, -0.16 cm"})
        overrides.push_back(more);
    const Outcome outcome = run_file(source_directory() + "/prm/whipple_shield.prm", folder, overrides);
    expect_sound_impact(table, outcome);
    const Problem<2>     read = read_problem<2>(source_directory() + "/prm/whipple_shield.prm", overrides);
    const ImpedanceMatch match =
        impedance_match(read.materials[0], read.materials[0], 0.1 * std::hypot(speed, sideways));
    table.at_most("largest pressure at any time / Hugoniot pressure of the impact",
                  largest_in_files(outcome.directory, "pressure") / match.pressure, 1.1);
    table.report("steps", outcome.steps());
  }

  /// Debris of the published case without strength: its fragments are drawn out into slivers.
  TEST(QuickChains, SliversDoNotSetTheClock)
  {
    Case       table("published case without strength, cells of 0.032 cm", "slivers of debris set the time step of all",
                     "eulerian, lagrangian fragments, eulerian");
    const auto debris = [](const char *folder, const char *effects) {
      return run_file(source_directory() + "/prm/whipple_shield.prm", folder,
                      {"Mesh/Finest cell = 0.032 cm", "Mesh/Levels = 2", std::string("Effects/List = ") + effects,
                       "Stages/wall/End = for 0.1 us", "Output/Fields interval = none"});
    };
    const Outcome strong = debris("slivers_strength", "strength, voids"), soft = debris("slivers", "voids");
    expect_sound_impact(table, soft);
    double locked = 0;
    for (const auto &[what, event] : soft.summary().counts.events)
      if (what.find("locked in their shape") != std::string::npos)
        locked += event.number;
    table.above("elements locked in their shape", locked, 0.);
    // 3.6 without locking; 200 on cells of 0.016 cm, where slivers are thinner
    table.at_most("steps of the debris stage / those with strength",
                  static_cast<double>(soft.summary().stages[1].steps) / strong.summary().stages[1].steps, 2.);
  }
  TEST(QuickChains, OneKilometreASecond)
  {
    expect_chain(1., 0.);
  }
  TEST(Chains, HundredMetresASecond)
  {
    expect_chain(0.1, 0.);
  }
  TEST(Chains, FiveHundredMetresASecond)
  {
    expect_chain(0.5, 0.);
  }
  TEST(Chains, TwoKilometresASecond)
  {
    expect_chain(2., 0.);
  }
  TEST(Chains, Oblique)
  {
    expect_chain(1., 1.);
  }
} // namespace
