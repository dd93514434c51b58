// SPDX-License-Identifier: LGPL-2.1-or-later
#include "complaint.h"
#include "source_directory.h"

#include <whipple/error.h>
#include <whipple/problem/problem.h>
#include <whipple/scene/sphere_shape.h>
#include <whipple/scene/variables.h>

#include <gtest/gtest.h>

#include <cmath>
#include <filesystem>
#include <fstream>
#include <numbers>

/// Scenes made of several files, with variables, and with bodies placed by what they touch.
namespace
{
  namespace fs = std::filesystem;
  using namespace whipple;

  const std::string shield = std::string(source_directory()) + "/prm/whipple_shield.prm";

  class SceneFiles : public testing::Test
  {
  protected:
    void
    SetUp() override
    {
      fs::remove_all(folder);
      fs::create_directories(folder / "parts");
    }
    void
    TearDown() override
    {
      fs::remove_all(folder);
    }
    std::string
    write(const std::string &name, const std::string &text) const
    {
      std::ofstream(folder / name) << text;
      return (folder / name).string();
    }
    fs::path folder = fs::path(testing::TempDir()) / "whipple scene files";
  };

  TEST_F(SceneFiles, IncludedStatementsStandWhereTheIncludeStands)
  {
    write("parts/steel.prm", "set Yield = 1\ninclude more.prm\nsubsection deep\n  set Last = 4\nend\n");
    write("parts/more.prm", "set Density = 2\n");
    const auto statements = read_prm_statements(
        write("scene.prm", "subsection Materials\n  include parts/steel.prm\n  set Yield = 3\nend\nset Title = x\n"));
    std::string text;
    for (const PrmStatement &statement : statements)
      text += statement.name() + '=' + statement.value + ' ';
    EXPECT_EQ(text, "Materials/Density=2 Materials/deep/Last=4 Materials/Yield=3 Title=x ");
    EXPECT_TRUE(statements[0].origin.ends_with("more.prm:1")) << statements[0].origin;
  }

  TEST_F(SceneFiles, WrongIncludesAreOneClearLine)
  {
    const auto reading = [&](const std::string &text) {
      const std::string file = write("scene.prm", text);
      return complaint_of([&] { read_prm_statements(file); });
    };
    write("twice.prm", "set Title = y\n");
    write("open.prm", "subsection a\n");
    write("close.prm", "end\n");
    write("round.prm", "include scene.prm\n");
    EXPECT_TRUE(contains(reading("include none.prm\n"), "scene.prm:1: include none.prm: "));
    EXPECT_TRUE(contains(reading("include parts\n"), "is no file"));
    EXPECT_TRUE(contains(reading("include scene.prm\n"), "the file includes itself"));
    EXPECT_TRUE(contains(reading("include round.prm\n"), "round.prm:1: include scene.prm: the file includes itself"));
    EXPECT_TRUE(contains(reading("set Title = x\ninclude twice.prm\n"), "twice.prm:1: Title = 'y': is set twice"));
    EXPECT_TRUE(contains(reading("include twice.prm\ninclude twice.prm\n"), "is set twice"));
    EXPECT_TRUE(contains(reading("include open.prm\nend\n"), "open.prm: subsection 'a' is not closed"));
    EXPECT_TRUE(contains(reading("subsection a\ninclude close.prm\n"), "close.prm:1: 'end' without"));
    EXPECT_EQ(reading("include twice.prm\nset Title = x\n"), "");
  }

  std::vector<PrmStatement>
  substituted(std::vector<PrmStatement> statements)
  {
    substitute_variables(statements);
    return statements;
  }

  TEST(Variables, StandForTheirText)
  {
    const auto result = substituted({{"a:1", "", "Variables", "d = 0.32 cm, place = 0 cm, -0.16 cm, v=${d}"},
                                     {"a:2", "Bodies/ball", "Diameter", "$d"},
                                     {"a:3", "Bodies/ball", "Center", "$place"},
                                     {"a:4", "", "Title", "ball of ${d}, $v"}});
    ASSERT_EQ(result.size(), 3u);
    EXPECT_EQ(result[0].value, "0.32 cm");
    EXPECT_EQ(result[1].value, "0 cm, -0.16 cm");
    EXPECT_EQ(result[2].value, "ball of 0.32 cm, 0.32 cm");
  }

  TEST(Variables, TheLastDefinitionCountsWhereverItsNameIsUsed)
  {
    const auto result = substituted({{"a:1", "Variables", "d", "1 cm"},
                                     {"a:2", "Variables", "twice", "$d and $d"},
                                     {"a:3", "", "Title", "$twice"},
                                     {"--set", "Variables", "d", "2 cm"}});
    ASSERT_EQ(result.size(), 1u);
    EXPECT_EQ(result[0].value, "2 cm and 2 cm");
  }

  TEST(Variables, WhatIsWrongIsOneClearLine)
  {
    const auto reading = [](const std::vector<PrmStatement> &statements) {
      return complaint_of([&] { substituted(statements); });
    };
    const PrmStatement use{"a:2", "", "Title", "$d"};
    EXPECT_TRUE(contains(reading({use}), "a:2: Title = '$d': no variable 'd'; the scene defines none"));
    EXPECT_TRUE(contains(reading({{"a:1", "Variables", "e", "1"}, use}), "no variable 'd'; "));
    EXPECT_TRUE(contains(reading({{"a:1", "Variables", "d", "$d"}, use}), "a:1: Variables/d = '$d': no variable 'd'"));
    EXPECT_TRUE(contains(reading({{"a:1", "Variables", "2d", "1"}}), "no name of a variable"));
    EXPECT_TRUE(contains(reading({{"a:1", "", "Variables", "1 cm"}}), "allowed is 'name = value"));
    EXPECT_TRUE(contains(reading({{"a:1", "", "Title", "${d"}}), "'${' without its '}'"));
    EXPECT_TRUE(contains(reading({{"a:1", "", "Title", "5 $"}}), "no variable ''"));
    EXPECT_TRUE(contains(reading({{"--set", "Variables", "d", "1"}}), "no value of the scene uses $d"));
    EXPECT_EQ(reading({{"a:1", "Variables", "d", "1"}}), "") << "a file may define more than it uses";
  }

  Vector<2>
  center_of(const std::vector<std::string> &overrides)
  {
    const Problem<2> problem = read_problem<2>(shield, overrides);
    return problem.scene.bodies[0].shape.as<Sphere<2>>()->center;
  }

  const std::string touching = "Bodies/sphere/Touching = bumper";

  TEST(Touching, ABallLiesOnThePlateItFliesTo)
  {
    for (const double diameter : {0.32, 0.1, 0.5})
      EXPECT_NEAR(center_of({touching, "Bodies/sphere/Diameter = " + std::to_string(diameter) + " cm"})[1],
                  -0.5 * diameter, 1e-14);
    // in flight against axis 1 on the other face, 0.0794 cm behind
    EXPECT_NEAR(center_of({touching, "Bodies/sphere/Velocity = 0 km/s, -6.58 km/s", "Bodies/sphere/Diameter = 0.1 cm",
                           "Bodies/bumper/Thickness = 0.0794 cm"})[1],
                0.0794 + 0.05, 1e-14);
  }

  TEST(Touching, ATurnedPlateIsMetWhereItIs)
  {
    const std::vector<std::string> planar{touching,
                                          "Geometry/Symmetry = planar",
                                          "Geometry/Left = transmitting",
                                          "Geometry/Lower corner = -1.024 cm, -1.024 cm",
                                          "Bodies/sphere/Center = 0.1 cm, 0 cm",
                                          "Bodies/sphere/Diameter = 0.2 cm",
                                          "Bodies/bumper/Rotation = 30 deg",
                                          "Bodies/bumper/Rotation center = 0 cm, 0 cm"};
    const Vector<2>                center = center_of(planar);
    // the face was y = 0: turned, its points are at sin(30) x - cos(30) y = 0, and the ball is a radius before it
    const double angle = std::numbers::pi / 6;
    EXPECT_EQ(center[0], 0.1);
    EXPECT_NEAR(std::sin(angle) * center[0] - std::cos(angle) * center[1], 0.1, 1e-9);
  }

  TEST(Touching, WhatCannotTouchIsOneClearLine)
  {
    const auto reading = [](const std::vector<std::string> &overrides) {
      return complaint_of([&] { read_problem<2>(shield, overrides); });
    };
    EXPECT_TRUE(contains(reading({"Bodies/sphere/Touching = bumpr"}), "did you mean 'bumper'"));
    EXPECT_TRUE(contains(reading({"Bodies/sphere/Touching = sphere"}), "touch itself"));
    EXPECT_TRUE(contains(reading({touching, "Bodies/bumper/Touching = sphere"}), "touch itself"));
  }
} // namespace
