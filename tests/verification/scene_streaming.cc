// SPDX-License-Identifier: LGPL-2.1-or-later
// A sphere, a bumper and a wall: debris that is laid down as it arrives does to the wall what it does laid down at
// once.
#include "scene_run.h"

#include <gtest/gtest.h>

namespace
{
  using namespace whipple;

  std::unique_ptr<Simulation<2>>
  shield(const std::string &landing, const std::string &folder, const std::string &end)
  {
    return verification::run("whipple_shield.prm",
                             {"Mesh/Finest cell = 0.032 cm", "Mesh/Levels = 3", "Output/Fields interval = none",
                              "Bodies/wall/Front face = 2.081 cm", "Geometry/Upper corner = 4.096 cm, 3.072 cm",
                              "Stages/wall/End = " + end, "Stages/wall/Hand-over = " + landing},
                             "streaming_" + folder);
  }

  double
  number(const Simulation<2> &simulation, const std::string &place, const std::string &quantity)
  {
    return std::get<double>(simulation.summary().results.at(place).at(quantity));
  }

  TEST(Streaming, DoesToAWallWhatAllAtOnceDoes)
  {
    const auto  once = shield("at once", "once", "for 5 us"), stream = shield("as it arrives", "stream", "for 5 us");
    const auto &a = once->summary(), &b = stream->summary();
    // up to the wall all is the same
    EXPECT_EQ(a.stages[2].start_us, b.stages[2].start_us);
    EXPECT_EQ(number(*once, "debris", "mass_g"), number(*stream, "debris", "mass_g"));
    for (const auto *ledger : {&a.ledger, &b.ledger})
      {
        EXPECT_LT(ledger->mass.closure_relative, 1e-12);
        EXPECT_LT(ledger->axial_momentum.closure_relative, 1e-12);
        EXPECT_LT(ledger->energy.closure_relative, 1e-11);
      }
    // it did arrive in parts, and what has not landed still waits
    const auto &landed = b.counts.events.at("debris laid down as it arrived");
    EXPECT_GT(landed.number, 3.);
    EXPECT_GT(landed.size, 0.8 * number(*stream, "debris", "mass_g"));
    EXPECT_FALSE(a.counts.events.contains("debris laid down as it arrived"));
    const auto &left = b.counts.events.at("parts of debris still on its way at the end");
    EXPECT_NEAR(landed.size + left.size, number(*stream, "debris", "mass_g"), 1e-12);
    // the window holds what has come only
    EXPECT_LT(b.stages[2].cell_steps / static_cast<double>(b.stages[2].steps),
              a.stages[2].cell_steps / static_cast<double>(a.stages[2].steps));
    // the wall's motion is that of the same blow
    const double wall_a = a.ledger.bodies.at("wall").at("axial_momentum_g_cm_per_us"),
                 wall_b = b.ledger.bodies.at("wall").at("axial_momentum_g_cm_per_us");
    EXPECT_NEAR(wall_b, wall_a, 0.02 * wall_a);
    EXPECT_NEAR(number(*stream, "wall", "crater_depth_cm"), number(*once, "wall", "crater_depth_cm"), 0.032);
  }

  /// At the end of a run that is too short for it, what has not arrived is told; it counts as present.
  TEST(Streaming, WhatHasNotArrivedIsTold)
  {
    const auto   run  = shield("as it arrives", "short", "for 0.3 us");
    const auto  &left = run->summary().counts.events.at("parts of debris still on its way at the end");
    const double mass = number(*run, "debris", "mass_g");
    EXPECT_GT(left.size, 0.2 * mass);
    EXPECT_LT(left.size, mass);
    EXPECT_LT(run->summary().ledger.mass.closure_relative, 1e-12);
    EXPECT_LT(run->summary().ledger.energy.closure_relative, 1e-11);
  }
} // namespace
