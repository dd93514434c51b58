// SPDX-License-Identifier: LGPL-2.1-or-later
// What `Effects/List = auto` makes of scenes: the impacts it sees, and its verdicts.
#include "source_directory.h"

#include <whipple/problem/effect_forecast.h>

#include <gtest/gtest.h>

#include <algorithm>
#include <string>
#include <vector>

namespace
{
  using namespace whipple;

  const std::string shield = source_directory() + "/prm/whipple_shield.prm";

  /// The shield with a model of every family, and more.
  Problem<2>
  complete_shield(std::vector<std::string> overrides)
  {
    const std::string material = "Materials/aluminium/";
    overrides.insert(overrides.begin(),
                     {material + "Thermal model = constant specific heat", material + "Failure = spall",
                      material + "Fragments = grady-kipp", material + "Conduction = constant conductivity"});
    return read_problem<2>(shield, overrides);
  }

  const EffectVerdict &
  verdict(const std::vector<EffectVerdict> &verdicts, const std::string &name)
  {
    return *std::find_if(verdicts.begin(), verdicts.end(), [&](const EffectVerdict &v) { return v.name == name; });
  }

  TEST(EffectForecast, ImpedanceMatchOfTheShield)
  {
    // aluminium 2024 on itself at 6.58 km/s: rho0 (c0 + s u) u with u = 3.29 km/s is 89.15 GPa (another program: 89.2)
    const std::vector<Encounter> all = encounters(read_problem<2>(shield));
    ASSERT_EQ(all.size(), 2u); // on the bumper and, if nothing stops it, on the wall
    EXPECT_NEAR(all[0].pressure, 2.785 * (0.5328 + 1.338 * 0.329) * 0.329, 1e-6);
    EXPECT_NEAR(all[0].stress, all[0].pressure / 0.00345, 1e-3);
    EXPECT_NEAR(all[0].tension, all[0].pressure / 0.012, 1e-3);
    EXPECT_TRUE(all[0].is_known);
  }

  TEST(EffectForecast, AShieldNeedsNearlyEverything)
  {
    const Problem<2> problem = complete_shield({"Effects/List = auto"});
    for (const char *on : {"strength", "voids", "melting", "failure", "body tags", "fragment size"})
      EXPECT_TRUE(problem.scene.has_effect(on)) << on;
    EXPECT_GT(verdict(problem.scene.effect_verdicts, "melting").number.value(), 1.); // it melts on release
    EXPECT_FALSE(verdict(problem.scene.effect_verdicts, "strength").reason.empty());
    // 121 W/m/K, 863 J/kg/K, 2785 kg/m^3 in 3.5 us of joined cells: 0.0133 mm, a third of a cell
    EXPECT_FALSE(problem.scene.has_effect("heat conduction"));
    EXPECT_NEAR(verdict(problem.scene.effect_verdicts, "heat conduction").number.value(), 0.33, 0.01);
  }

  TEST(EffectForecast, ATapNeedsLittle)
  {
    const Problem<2> problem = complete_shield(
        {"Effects/List = auto", "Bodies/sphere/Velocity = 0 km/s, 0.05 km/s", "Stages/List = perforation"});
    EXPECT_TRUE(problem.scene.has_effect("strength"));
    for (const char *off : {"voids", "melting", "failure", "fragment size", "heat conduction"})
      EXPECT_FALSE(problem.scene.has_effect(off)) << off;
    EXPECT_EQ(problem.materials[0].model.void_law, nullptr);
    EXPECT_NE(problem.materials[0].complete.void_law, nullptr);
  }

  TEST(EffectForecast, WhatIsListedBesideAutoIsOn)
  {
    const Problem<2> problem = complete_shield({"Effects/List = auto, heat conduction"});
    EXPECT_TRUE(problem.scene.has_effect("heat conduction"));
    EXPECT_EQ(verdict(problem.scene.effect_verdicts, "heat conduction").reason, "listed by the scene");
  }

  TEST(EffectForecast, ThinCellsConduct)
  {
    const Problem<2> problem = complete_shield(
        {"Effects/List = auto", "Stages/List = perforation", "Mesh/Finest cell = 0.001 cm", "Mesh/Levels = 7"});
    EXPECT_TRUE(problem.scene.has_effect("heat conduction"));
  }

  TEST(EffectForecast, WithoutModelsNothingIsChosen)
  {
    const std::vector<EffectVerdict> verdicts =
        forecast_effects(read_problem<2>(source_directory() + "/prm/verification/sod.prm"));
    for (const char *name : {"strength", "voids", "melting", "failure", "heat conduction", "fragment size"})
      {
        EXPECT_FALSE(verdict(verdicts, name).on) << name;
        EXPECT_NE(verdict(verdicts, name).reason.find("no material names a model"), std::string::npos);
      }
  }
} // namespace
