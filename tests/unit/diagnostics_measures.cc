// SPDX-License-Identifier: LGPL-2.1-or-later
// Measures register themselves in an order of their own; what they promise is what a run has at its end.
#include "source_directory.h"

#include <whipple/diagnostics/measure.h>
#include <whipple/run/resume.h>

#include <gtest/gtest.h>

#include <filesystem>

namespace
{
  using namespace whipple;

  TEST(Measures, AreInTheirOrder)
  {
    std::vector<std::string> names;
    for (const auto &[key, entry] : MeasureRegistry<2>::all())
      {
        names.push_back(key.second);
        EXPECT_TRUE(entry.measure || entry.watch) << key.second;
      }
    EXPECT_EQ(names,
              (std::vector<std::string>{"debris cloud", "phases", "fragments", "debris by angle and velocity", "plates",
                                        "load on the last plate", "gauges", "shock of the exact solution", "history"}));
  }

  std::vector<std::string>
  names_of(const std::map<std::string, ResultTable> &results)
  {
    std::vector<std::string> names;
    for (const auto &[place, table] : results)
      for (const auto &[quantity, value] : table)
        names.push_back(place + '/' + quantity);
    return names;
  }

  TEST(Measures, KeepTheirPromise)
  {
    std::filesystem::create_directories("measures_output");
    const std::vector<std::string> shield{"Mesh/Finest cell = 0.064 cm", "Output/Fields interval = none",
                                          "Stages/perforation/End = 0.2 us", "Stages/debris/End = for 0.1 us",
                                          "Stages/List = perforation, debris"};
    const std::vector<std::string> tube{"Stages/tube/End = 0.01 us"};
    for (const auto &[file, settings] :
         {std::pair("/prm/whipple_shield.prm", shield), std::pair("/prm/verification/sod.prm", tube)})
      {
        const Problem<2> problem    = read_problem<2>(source_directory() + file, settings);
        const auto       simulation = start(problem, {"measures_output/run"}, EarlierRun::replaced, MPI_COMM_SELF);
        simulation->run();
        const auto expected = names_of(expected_results(problem));
        EXPECT_GT(expected.size(), 2u) << file;
        EXPECT_EQ(names_of(simulation->summary().results), expected) << file;
        EXPECT_FALSE(std::filesystem::exists("measures_output/run/gauges"));
      }
  }
} // namespace
