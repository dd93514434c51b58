// SPDX-License-Identifier: LGPL-2.1-or-later
// What a scene says before it runs: warnings, and what is refused because only a later stage would notice.
#include "source_directory.h"

#include <whipple/error.h>
#include <whipple/problem/effect_forecast.h>
#include <whipple/problem/scene_warnings.h>

#include <gtest/gtest.h>

#include <chrono>
#include <cstdio>
#include <filesystem>
#include <fstream>
#include <sstream>

namespace
{
  using namespace whipple;

  const std::string shield   = source_directory() + "/prm/whipple_shield.prm";
  const std::string saltzman = source_directory() + "/prm/verification/saltzman.prm";

  /// All warnings of the shield with these overrides, a line each.
  std::string
  warned(const std::vector<std::string> &overrides, const std::string &file = shield)
  {
    std::string all;
    for (const std::string &line : scene_warnings(read_problem<2>(file, overrides)))
      all += line + '\n';
    return all;
  }

  void
  expect_says(const std::string &text, const std::vector<std::string> &words)
  {
    for (const std::string &word : words)
      EXPECT_NE(text.find(word), std::string::npos) << "'" << word << "' is not in: " << text;
    EXPECT_EQ(std::count(text.begin(), text.end(), '\n'), 1) << text;
  }

  std::string
  complaint(const std::string &file, const std::vector<std::string> &overrides)
  {
    try
      {
        read_problem<2>(file, overrides);
      }
    catch (const InputError &error)
      {
        return error.what();
      }
    return "";
  }

  TEST(SceneWarnings, NoFalseAlarmAboutThePublishedShield)
  {
    EXPECT_EQ(warned({}), "");
    EXPECT_EQ(warned({"Mesh/Finest cell = 0.008 cm"}), "");
    EXPECT_EQ(warned({"Mesh/Finest cell = 0.016 cm"}), "");
    EXPECT_EQ(warned({"Stages/List = perforation"}), "");
  }

  TEST(SceneWarnings, ThinBodiesAndCoarseSpheres)
  {
    expect_says(warned({"Bodies/bumper/Thickness = 0.009 cm"}), {"body 'bumper'", "0.009 cm", "2.25 finest cells"});
    expect_says(warned({"Bodies/sphere/Diameter = 0.036 cm", "Bodies/sphere/Center = 0 cm, -0.018 cm",
                        "Bodies/bumper/Thickness = 0.02 cm"}),
                {"body 'sphere'", "0.036 cm", "9 finest cells"});
    // a wall of two cells that a symmetry plane doubles, and a strip as wide as the domain, are not thin
    EXPECT_EQ(warned({"Stages/List = perforation", "Geometry/Lower corner = 0 cm, 0 cm", "Geometry/Bottom = reflecting",
                      "Bodies/List = bumper", "Stages/perforation/Introduces = bumper",
                      "Bodies/bumper/Thickness = 0.008 cm"}),
              "");
  }

  TEST(SceneWarnings, StagesThatCannotEnd)
  {
    expect_says(warned({"Bodies/sphere/Velocity = 0 km/s, 0 km/s", "Stages/debris/Minimum axial velocity = 0 km/s"}),
                {"stage 'debris'", "'wall'", "cannot end"});
    expect_says(warned({"Bodies/sphere/Velocity = 0 km/s, 1 km/s", "Stages/debris/Minimum axial velocity = 2 km/s"}),
                {"stage 'debris'", "2 km/s", "1 km/s", "nothing will be left"});
  }

  TEST(SceneWarnings, DebrisThatLeaves)
  {
    // at V/4 = 1.6 km/s aside the debris is at r = 2.048 cm after 11.5 us; the wall is reached at 15.6 us
    expect_says(warned({"Geometry/Upper corner = 2.048 cm, 11.264 cm"}),
                {"debris of body 'sphere'", "right", "11.5 us"});
    // nothing is in the way: 11.264 cm at 6.58 km/s
    expect_says(warned({"Stages/List = perforation", "Stages/perforation/Introduces = sphere",
                        "Stages/perforation/End = 20 us"}),
                {"body 'sphere'", "upper", "17.1 us", "20 us"});
    EXPECT_EQ(warned({"Stages/List = perforation", "Stages/perforation/Introduces = sphere",
                      "Stages/perforation/End = 17 us"}),
              "");
    // a side that holds what comes
    EXPECT_EQ(warned({"Geometry/Upper corner = 2.048 cm, 11.264 cm", "Geometry/Right = reflecting"}), "");
  }

  TEST(SceneWarnings, MemoryAndTime)
  {
    const std::string fine = warned({"Mesh/Finest cell = 0.0005 cm", "Mesh/Levels = 8"});
    EXPECT_NE(fine.find(" GB of memory"), std::string::npos) << fine;
    EXPECT_NE(fine.find(" of one core"), std::string::npos) << fine;
    // measured (doc/performance.md): 118 s on one core, 66,742 cells, 8,589 steps; a factor of 3 is what an estimate
    // may miss
    const CostEstimate cost = estimate_cost(read_problem<2>(shield));
    EXPECT_GT(cost.seconds, 118. / 3.);
    EXPECT_LT(cost.seconds, 118. * 3.);
    EXPECT_GT(cost.cells, 66742. / 3.);
    EXPECT_LT(cost.cells, 66742. * 3.);
    EXPECT_GT(cost.steps, 8589. / 3.);
    EXPECT_LT(cost.steps, 8589. * 3.);
  }

  TEST(SceneWarnings, ALawThatKeepsAPressureInVacuum)
  {
    // -c1 - c3 + c4 gamma0 e = 0: K (1 + 0.337 * 1.011) / (2 gamma0) of aluminium is 19 MJ/kg, as 12.4 km/s brings
    const std::string law = "Materials/aluminium/Equation of state = linear polynomial";
    EXPECT_EQ(warned({law}), "");
    const std::string fast = warned({law, "Bodies/sphere/Velocity = 0 km/s, 15 km/s"});
    for (const char *word : {"material 'aluminium'", "linear polynomial", "15 km/s", "0.281 Mbar cm^3/g"})
      EXPECT_NE(fast.find(word), std::string::npos) << fast;
    EXPECT_EQ(warned({"Bodies/sphere/Velocity = 0 km/s, 15 km/s"}).find("keeps"), std::string::npos);
  }

  TEST(SceneWarnings, AFitWithoutDuctility)
  {
    const std::vector<std::string> bar{
        "Materials/aluminium/Library = aluminium 6061-T6", "Materials/aluminium/Thermal model = constant specific heat",
        "Materials/aluminium/Failure = johnson-cook damage", "Effects/List = strength, voids, body tags, failure"};
    expect_says(warned(bar), {"material 'aluminium'", "1.35"}); // ln(1.45/0.77)/0.47 = 1.3467
    std::vector<std::string> copper = bar;
    copper[0]                       = "Materials/aluminium/Library = copper OFHC"; // 0.54 + 4.89 exp(-3.03 s) > 0
    EXPECT_EQ(warned(copper), "");
  }

  TEST(SceneWarnings, AllComeInOneLineEach)
  {
    const std::string text =
        warned({"Bodies/bumper/Thickness = 0.009 cm", "Geometry/Upper corner = 2.048 cm, 11.264 cm"});
    EXPECT_EQ(std::count(text.begin(), text.end(), '\n'), 2) << text;
  }

  TEST(SceneChecks, InflowFasterThanSoundOnAFixedMesh)
  {
    // gamma = 5/3, strong shock: c = (gamma (gamma - 1)/2)^(1/2) V = 0.745 V behind it, with the 0.01 Mbar cm^3/g ahead
    // a little more
    const std::string fixed = complaint(saltzman, {"Geometry/Mesh map = none", "Stages/push/Mode = eulerian"});
    for (const char *words : {"Geometry/Bottom", "inflow 0 cm/us, 1 cm/us", "faster than sound", "0.7", "lagrangian"})
      EXPECT_NE(fixed.find(words), std::string::npos) << fixed;
    EXPECT_EQ(complaint(saltzman, {"Geometry/Mesh map = none"}), "") << "on a moving mesh a piston may be fast";
    const std::vector<std::string> eulerian{"Geometry/Mesh map = none", "Stages/push/Mode = eulerian"};
    auto                           slow = eulerian;
    slow.push_back("Bodies/gas/Specific energy = 1 Mbar cm^3/g"); // c = 1.05 cm/us before the shock
    EXPECT_EQ(complaint(saltzman, slow), "");
    auto wind = eulerian;
    wind.push_back("Bodies/gas/Velocity = 0 cm/us, 1 cm/us"); // what enters is what is there
    wind.push_back("Exact solution/Name = none");
    EXPECT_EQ(complaint(saltzman, wind), "");
  }

  TEST(SceneChecks, AVoidLawThatOnlyTheSecondStageWouldMiss)
  {
    // the void law is given, but the effect that it belongs to is off
    const std::string effects = "Effects/List = strength, body tags";
    const std::string said    = complaint(shield, {effects});
    for (const char *words : {"Materials/aluminium/Void law", "stage 'debris'", "void law", "effect 'voids'"})
      EXPECT_NE(said.find(words), std::string::npos) << said;
    EXPECT_EQ(complaint(shield, {effects, "Stages/List = perforation"}), "");
    EXPECT_EQ(complaint(shield, {effects, "Stages/debris/Void cutoff = 0 %"}), "") << "only full cells go on";
    EXPECT_EQ(complaint(shield, {effects, "Stages/debris/Mode = eulerian"}), "");
    // nothing moves, and faces on mesh lines stay there: cells can be full
    const std::vector<std::string> still{effects, "Bodies/List = bumper, wall",
                                         "Stages/perforation/Introduces = bumper", "Stages/debris/End = 2 us",
                                         "Bodies/bumper/Thickness = 0.08 cm"};
    EXPECT_EQ(complaint(shield, still), "");
    auto off_the_lines   = still;
    off_the_lines.back() = "Bodies/bumper/Thickness = 0.081 cm";
    EXPECT_NE(complaint(shield, off_the_lines), "");
  }

  /// A row of boxes, each with a velocity of its own.
  class Row
  {
  public:
    Row(int bodies, const std::string &effects)
      : path_(testing::TempDir() + "whipple_row.prm")
    {
      std::ofstream file(path_);
      file << "subsection Geometry\n set Symmetry = planar\n set Lower corner = 0 cm, 0 cm\n set Upper corner = "
           << bodies << " cm, 1 cm\nend\nsubsection Mesh\n set Finest cell = 1 cm\n set Levels = 0\nend\n"
           << "subsection Effects\n set List = " << effects << "\nend\n"
           << "subsection Materials\n set List = m\n subsection m\n set Library = aluminium 2024-T4\n"
           << " set Strength = perfectly plastic\n set Yield stress = 345 MPa\n end\nend\n"
           << "subsection Bodies\n set List = b0";
      for (int b = 1; b < bodies; ++b)
        file << ", b" << b;
      for (int b = 0; b < bodies; ++b)
        file << "\n subsection b" << b << "\n set Shape = box\n set Lower corner = " << b << " cm, 0 cm\n"
             << " set Upper corner = " << b + 1 << " cm, 1 cm\n set Material = m\n set Velocity = 0 km/s, "
             << (b % 2 ? 1 : -1) * 0.001 * b << " km/s\n end";
      file << "\nend\nsubsection Stages\n set List = s\n subsection s\n set End = 1 us\n end\nend\n";
    }
    ~Row()
    {
      std::remove(path_.c_str());
    }
    double
    seconds_to_read() const
    {
      const auto       start   = std::chrono::steady_clock::now();
      const Problem<2> problem = read_problem<2>(path_);
      EXPECT_TRUE(problem.scene.has_effect("strength"));
      return std::chrono::duration<double>(std::chrono::steady_clock::now() - start).count();
    }
    const std::string &
    path() const
    {
      return path_;
    }

  private:
    std::string path_;
  };

  // 200 bodies of 200 velocities are 19,900 pairs, a millisecond and more each if all were solved: 30 s and more.
  TEST(ManyBodies, AreReadInSeconds)
  {
    EXPECT_LT(Row(200, "strength").seconds_to_read(), 5.);
    EXPECT_LT(Row(200, "auto").seconds_to_read(), 5.);
  }

  TEST(ManyBodies, VerdictsNeedOnlyTheSlowestAndTheFastest)
  {
    const Row                    row(12, "auto");
    const Problem<2>             problem = read_problem<2>(row.path());
    const std::vector<Encounter> all = encounters(problem), extreme = extreme_encounters(problem);
    ASSERT_GT(all.size(), 20u);
    ASSERT_EQ(extreme.size(), 2u);
    double least = 1e300, most = 0;
    for (const Encounter &e : all)
      {
        least = std::min(least, e.stress);
        most  = std::max(most, e.pressure);
      }
    EXPECT_EQ(extreme.front().pressure, most);
    EXPECT_EQ(extreme.back().stress, least);
  }
} // namespace
