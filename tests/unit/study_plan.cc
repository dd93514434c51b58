// SPDX-License-Identifier: LGPL-2.1-or-later
#include "source_directory.h"

#include <whipple/error.h>
#include <whipple/problem/problem.h>
#include <whipple/study/study_plan.h>

#include <gtest/gtest.h>

#include <algorithm>
#include <cstdio>
#include <filesystem>
#include <fstream>
#include <regex>

namespace
{
  using namespace whipple;

  const std::string shield = source_directory() + "/prm/whipple_shield.prm";

  const std::string study_text = "subsection Study\n"
                                 "  set Scene     = " +
                                 shield +
                                 "\n"
                                 "  set Overrides = Stages/List = perforation | Output/Fields interval = none\n"
                                 "  set Axes      = cell, remap\n"
                                 "  subsection cell\n"
                                 "    set Parameter = Mesh/Finest cell\n"
                                 "    set Values    = 0.016 cm | 0.032 cm | 0.008 cm\n"
                                 "  end\n"
                                 "  subsection remap\n"
                                 "    set Parameter = Numerics/Remap order ; Numerics/Courant number\n"
                                 "    set Values    = 2 ; 0.5 | 1 ; 0.25\n"
                                 "    set Labels    = second order | donor cell\n"
                                 "  end\n"
                                 "end\n";

  /// A study file of the test's own, removed afterwards.
  class TemporaryStudy
  {
  public:
    /// `study_text` with the first `from` replaced by `to`.
    explicit TemporaryStudy(const std::string &from = "", const std::string &to = "")
    {
      std::string text = study_text;
      if (!from.empty())
        text.replace(text.find(from), from.size(), to);
      std::ofstream(path) << text;
    }
    ~TemporaryStudy()
    {
      std::remove(path.c_str());
    }

    const std::string path = testing::TempDir() + "whipple_study_plan.prm";
  };

  StudyPlan
  plan_of(const TemporaryStudy &file, const std::vector<std::string> &overrides = {})
  {
    StudyOptions options;
    options.file      = file.path;
    options.overrides = overrides;
    return plan_study(options, read_study(options));
  }

  std::vector<std::string>
  labels(const StudyPlan &plan)
  {
    std::vector<std::string> all;
    for (const StudyPoint &point : plan.points)
      all.push_back(point.label);
    return all;
  }

  /// The message a study is rejected with; empty if it is accepted.
  std::string
  complaint(const std::string &from, const std::string &to, const std::vector<std::string> &overrides = {})
  {
    const TemporaryStudy file(from, to);
    try
      {
        plan_of(file, overrides);
      }
    catch (const InputError &error)
      {
        return error.what();
      }
    return "";
  }

  TEST(StudyPlan, ProductHasEveryCombinationCoarseFirst)
  {
    const StudyPlan plan = plan_of(TemporaryStudy());
    EXPECT_EQ(labels(plan),
              (std::vector<std::string>{"cell=0.032cm,remap=secondorder", "cell=0.032cm,remap=donorcell",
                                        "cell=0.016cm,remap=secondorder", "cell=0.016cm,remap=donorcell",
                                        "cell=0.008cm,remap=secondorder", "cell=0.008cm,remap=donorcell"}));
    EXPECT_EQ(plan.points[0].cell, 0.032);
    EXPECT_EQ(plan.section.cell_axis(), std::optional<std::size_t>(0));
    EXPECT_EQ(plan.section.axes[0].base, 2u); // the finest
    // values of both parameters, and the study's own overrides, are in force
    const std::string &parameters = plan.points[1].effective_parameters;
    for (const char *entry : {"Remap order *= 1 ", "Courant number *= 0.25 ", "Fields interval *= none\n"})
      EXPECT_TRUE(std::regex_search(parameters, std::regex(entry))) << entry << parameters;
    // only the first stage: the bumper's results, none of the debris
    EXPECT_EQ(plan.results.size(), 1u);
    EXPECT_TRUE(plan.results.at("bumper").contains("hole_diameter_cm"));
  }

  TEST(StudyPlan, OneAtATimeVariesEachAxisFromTheBase)
  {
    const StudyPlan plan = plan_of(TemporaryStudy("set Axes ", "set Combination = one at a time\n  set Axes "),
                                   {"Study/cell/Base = 0.016 cm"});
    EXPECT_EQ(labels(plan), (std::vector<std::string>{"cell=0.032cm", "cell=0.016cm", "cell=0.016cm,remap=donorcell",
                                                      "cell=0.008cm"}));
    EXPECT_EQ(method_name(plan.section, plan.points[0].choice), "base");
    EXPECT_EQ(point_name(plan.section, plan.points[2].choice), "0.016 cm, remap: donor cell");
  }

  TEST(StudyPlan, PointsCanBeLeftOut)
  {
    const StudyPlan plan = plan_of(TemporaryStudy(
        "set Axes ", "set Leave out = cell = 0.008 cm, remap = donor cell | cell = 0.032 cm\n  set Axes "));
    EXPECT_EQ(labels(plan), (std::vector<std::string>{"cell=0.016cm,remap=secondorder", "cell=0.016cm,remap=donorcell",
                                                      "cell=0.008cm,remap=secondorder"}));
  }

  TEST(StudyPlan, RanksCanBeAnAxis)
  {
    const StudyPlan plan =
        plan_of(TemporaryStudy("Numerics/Remap order ; Numerics/Courant number\n    set Values    = 2 ; 0.5 | 1 ; 0.25",
                               "ranks\n    set Values    = 1 | 2"));
    EXPECT_EQ(plan.points[0].ranks, 1);
    EXPECT_EQ(plan.points[1].ranks, 2);
    EXPECT_EQ(plan.points[0].effective_parameters, plan.points[1].effective_parameters);
  }

  struct BadStudy
  {
    const char *from, *to;
    const char *words; ///< what the message must hold
  };

  TEST(StudyPlan, WhateverIsWrongIsOneLineThatLeadsToIt)
  {
    const std::vector<BadStudy> bad{
        {"Mesh/Finest cell\n", "Mesh/Finest cel\n",
         ":7: Mesh/Finest cel = '0.016 cm': no such key; did you mean 'Finest cell'"},
        {"Mesh/Finest cell\n", "Mish/Finest cell\n", "no such section; did you mean 'Mesh'"},
        {"0.032 cm", "0.032", "Study/cell/Values = '0.016 cm | 0.032 | 0.008 cm': the unit is missing"},
        {"0.032 cm", "0.016 cm", "is there twice"},
        {"0.032 cm", "0.0160 cm", "differ from one another"},
        {"1 ; 0.25", "1 ; 7", ":11: Numerics/Courant number = '7': out of range"},
        {"1 ; 0.25", "1", "'1' has 1 parts"},
        {"second order | donor cell", "second order", "one for each of the 2 values"},
        {"second order | donor cell", "second order | secondorder", "same directory"},
        {"second order | donor cell", "a, b | c", "is no label"},
        {"set Axes      = cell, remap", "set Axes      = cell, remap, more", "Study/more/Parameter"},
        {"set Axes      = cell, remap", "set Axes      = cell", "no such section; allowed are"},
        {"set Axes      = cell, remap", "set Axes      = ", "Study/Axes = '': must be given"},
        {"set Axes ", "set Axis ", "did you mean 'Axes'"},
        {"set Axes ", "set Repeats = 0\n  set Axes ", "whole number from 1 to 99"},
        {"set Axes ", "set Combination = all\n  set Axes ", "product, one at a time"},
        {"set Axes ", "set Leave out = cell = 0.5 cm\n  set Axes ", "axis 'cell' has no such label"},
        {"set Axes ", "set Results = bumper/hole\n  set Axes ", "allowed are bumper/crater_depth_cm"},
        {"set Axes ", "set Scen = x\n  set Axes ", "did you mean 'Scene'"},
        {"Numerics/Remap order ; ", "Numerics/Courant number ; ", "moved twice"},
        {"subsection Study\n", "set Title = more\nsubsection Study\n", "Title = 'more': the study names its scene"},
    };
    for (const BadStudy &study : bad)
      {
        const std::string message = complaint(study.from, study.to);
        EXPECT_NE(message.find(study.words), std::string::npos) << study.to << ": " << message;
        EXPECT_EQ(message.find('\n'), std::string::npos) << message;
      }
    EXPECT_NE(complaint("", "", {"Mesh/Finest cell = 1 cm"}).find("the axis 'cell' of the study moves it"),
              std::string::npos);
    StudyOptions scene;
    scene.file = shield;
    EXPECT_THROW(read_study(scene), InputError); // a scene without the section Study
  }

  TEST(StudyPlan, EveryShippedStudyIsValid)
  {
    int studies = 0;
    for (const auto &entry : std::filesystem::recursive_directory_iterator(source_directory() + "/prm"))
      if (entry.path().extension() == ".prm" && read_study_section(entry.path(), read_prm_statements(entry.path())))
        {
          StudyOptions options;
          options.file = entry.path();
          EXPECT_FALSE(plan_study(options, read_study(options)).points.empty()) << entry.path();
          ++studies;
        }
    EXPECT_GE(studies, 2);
  }

  // A run of a file that is a scene and a study checks the section and goes on without it.
  TEST(StudyPlan, RunsIgnoreTheSection)
  {
    const std::string own = study_text.substr(study_text.find("  set Overrides"));
    std::ifstream     input(shield);
    const std::string scene{std::istreambuf_iterator<char>(input), {}};
    const std::string path = testing::TempDir() + "whipple_scene_and_study.prm";
    std::ofstream(path) << scene << "\nsubsection Study\n" << own;
    EXPECT_EQ(read_problem<2>(path).scene.effective_parameters, read_problem<2>(shield).scene.effective_parameters);
    std::ofstream(path) << scene << "\nsubsection Study\n set Axis = cell\nend\n";
    EXPECT_THROW(read_problem<2>(path), InputError);
    std::remove(path.c_str());
    EXPECT_THROW(read_problem<2>(TemporaryStudy().path), InputError); // a study of another file's scene
  }
} // namespace
