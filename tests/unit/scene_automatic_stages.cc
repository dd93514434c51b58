// SPDX-License-Identifier: LGPL-2.1-or-later
// The chain of stages that the plates ask for.
#include <whipple/error.h>
#include <whipple/scene/automatic_stages.h>

#include <gtest/gtest.h>

#include <map>
#include <sstream>

namespace
{
  using namespace whipple;

  std::vector<PrmStatement>
  scene(const std::string &bodies, const std::string &stages = "")
  {
    std::istringstream text("subsection Effects\n set List = voids, fragment size\nend\n" + bodies +
                            "subsection Stages\n set List = automatic\n" + stages + "end\n");
    return read_prm_statements(text, "test.prm");
  }

  std::string
  plate(const std::string &name, double front, double thickness)
  {
    std::ostringstream text;
    text << " subsection " << name << "\n  set Shape = plate\n  set Front face = " << front
         << " cm\n  set Thickness = " << thickness << " mm\n end\n";
    return text.str();
  }

  const std::string ball = " subsection ball\n  set Shape = sphere\n end\n";

  /// What is set in the end.
  std::map<std::string, std::string>
  values(const std::vector<PrmStatement> &statements)
  {
    std::map<std::string, std::string> result;
    for (const PrmStatement &statement : statements)
      result[statement.name()] = statement.value;
    return result;
  }

  TEST(AutomaticStages, OneStageForEachPlateAndEachGap)
  {
    // listed out of order: what counts is where they stand
    auto statements = scene("subsection Bodies\n set List = wall, ball, first\n" + plate("wall", 10, 2) + ball +
                                plate("first", 0, 1) + "end\n",
                            " subsection debris 1\n  set Cohesion = graded\n end\n");
    expand_automatic_stages(statements);
    auto is = values(statements);
    EXPECT_EQ(is["Stages/List"], "perforation 1, debris 1, impact");
    EXPECT_EQ(is["Stages/perforation 1/Introduces"], "ball, first");
    EXPECT_EQ(is["Stages/perforation 1/End"], "until debris is free of first");
    EXPECT_EQ(is["Stages/debris 1/Mode"], "lagrangian");
    EXPECT_EQ(is["Stages/debris 1/Debris behind"], "first");
    EXPECT_EQ(is["Stages/debris 1/End"], "until leading edge reaches wall");
    EXPECT_EQ(is["Stages/debris 1/Cohesion"], "graded") << "what the scene says counts";
    EXPECT_EQ(is["Stages/impact/Introduces"], "wall");
    EXPECT_EQ(is["Stages/impact/Representation"], "fragments");
    EXPECT_EQ(is["Stages/perforation 1/Plates measured"], "settled");
    EXPECT_EQ(is.count("Stages/impact/Plates measured"), 0u);
  }

  TEST(AutomaticStages, HowDebrisLandsIsSaidOnceForAllStages)
  {
    auto statements = scene("subsection Bodies\n set List = wall, ball, first, second\n" + plate("wall", 10, 2) + ball +
                                plate("first", 0, 1) + plate("second", 5, 1) + "end\n",
                            " set Hand-over = as it arrives\n subsection impact\n  set Hand-over = at once\n end\n");
    expand_automatic_stages(statements);
    auto is = values(statements);
    EXPECT_EQ(is.count("Stages/perforation 1/Hand-over"), 0u) << "nothing lands in the first stage";
    EXPECT_EQ(is["Stages/perforation 2/Hand-over"], "as it arrives");
    EXPECT_EQ(is["Stages/impact/Hand-over"], "at once") << "what the scene says of a stage counts";
    EXPECT_EQ(is.count("Stages/Hand-over"), 0u);
  }

  TEST(AutomaticStages, WhatCannotBeOrderedIsNamed)
  {
    const auto complaint = [](const std::string &bodies) {
      auto statements = scene("subsection Bodies\n" + bodies + "end\n");
      try
        {
          expand_automatic_stages(statements);
        }
      catch (const InputError &error)
        {
          return std::string(error.what());
        }
      return std::string();
    };
    EXPECT_NE(complaint(" set List = ball\n" + ball).find("no body of the scene has the shape 'plate'"),
              std::string::npos);
    EXPECT_NE(complaint(" set List = a, b\n" + plate("a", 0, 2) + plate("b", 0.1, 2)).find("overlaps 'a'"),
              std::string::npos);
    EXPECT_NE(complaint(" set List = a\n subsection a\n  set Shape = plate\n end\n").find("Bodies/a/Front face"),
              std::string::npos);
  }

  TEST(AutomaticStages, AListOfNamesIsLeftAlone)
  {
    std::istringstream text("subsection Stages\n set List = a, b\nend\n");
    auto               statements = read_prm_statements(text, "test.prm");
    expand_automatic_stages(statements);
    EXPECT_EQ(statements.size(), 1u);
    EXPECT_EQ(statements[0].value, "a, b");
  }
} // namespace
