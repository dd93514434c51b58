// SPDX-License-Identifier: LGPL-2.1-or-later
#include <whipple/error.h>
#include <whipple/output/manifest.h>
#include <whipple/output/output_directory.h>
#include <whipple/output/process_use.h>
#include <whipple/output/run_log.h>
#include <whipple/output/step_table.h>
#include <whipple/output/time_left.h>

#include <gtest/gtest.h>

#include <array>
#include <cmath>
#include <cstdlib>
#include <filesystem>
#include <fstream>
#include <sstream>
#include <string>

namespace
{
  using namespace whipple;
  namespace fs = std::filesystem;

  /// An empty directory for one test.
  class OutputText : public testing::Test
  {
  protected:
    OutputText()
    {
      fs::remove_all(directory);
      fs::create_directories(directory);
    }
    ~OutputText() override
    {
      fs::remove_all(directory);
    }

    std::string
    content(const std::string &name) const
    {
      std::ifstream      file(directory / name);
      std::ostringstream text;
      text << file.rdbuf();
      return text.str();
    }

    const fs::path directory =
        fs::current_path() / (std::string("whipple_") + testing::UnitTest::GetInstance()->current_test_info()->name());
  };

  TEST_F(OutputText, StatisticsRowsReadBackExactly)
  {
    const std::array<TableEntry, 3> first{{{"time [us]", 0.1 + 0.2}, {"mass [g]", 1e-300}, {"steps", 7.}}};
    const std::array<TableEntry, 3> second{{{"time [us]", 1. / 3.}, {"mass [g]", NAN}, {"steps", 8.}}};
    const std::array<TableEntry, 3> renamed{{{"time [s]", 0.}, {"mass [g]", 0.}, {"steps", 0.}}};
    StepTable                       statistics(directory.string() + "/statistics.csv", MPI_COMM_SELF);
    statistics.write(first);
    statistics.write(second);
    EXPECT_THROW(statistics.write(renamed), Error);
    EXPECT_THROW(statistics.write(std::span(first).first(2)), Error);
    statistics.keep();
    statistics.flush();

    std::istringstream table(content("statistics.csv"));
    std::string        line;
    std::getline(table, line);
    EXPECT_EQ(line, "time [us],mass [g],steps");
    std::getline(table, line);
    char *end = nullptr;
    EXPECT_EQ(std::strtod(line.c_str(), &end), 0.1 + 0.2);
    EXPECT_EQ(std::strtod(end + 1, &end), 1e-300);
    EXPECT_EQ(std::string(end), ",7");
    std::getline(table, line);
    EXPECT_NE(line.find(",nan,8"), std::string::npos);
  }

  TEST_F(OutputText, LogGoesToFileAndTerminal)
  {
    std::ostringstream terminal;
    {
      RunLog log(directory.string(), MPI_COMM_SELF, terminal, false, 0.);
      log.banner();
      log.info("a line");
      log.warning("thin ice");
      log.warning("thinner ice");
      EXPECT_EQ(log.warnings(), 2);
    }
    EXPECT_EQ(terminal.str(), content("log.txt"));
    EXPECT_TRUE(terminal.str().starts_with("Whipple "));
    EXPECT_NE(terminal.str().find("p4est"), std::string::npos);
    EXPECT_NE(terminal.str().find("\nwarning: thin ice\n"), std::string::npos);
  }

  TEST_F(OutputText, ProgressIsPlainLinesOffATerminal)
  {
    std::ostringstream terminal;
    RunLog             log(directory.string(), MPI_COMM_SELF, terminal, false, 3600.);
    const Progress     progress{"perforation", 12, 0.5, 1e-3, "sound speed", 4711, 0.25};
    log.progress(progress);
    log.progress(progress); // not due yet
    const std::string text = terminal.str();
    EXPECT_EQ(text.find('\r'), std::string::npos);
    EXPECT_EQ(text.find("perforation: step 12, t = 0.5 us, dt = 1.000e-03 us (sound speed), 4711 cells, 25.0 %"), 0u);
    EXPECT_EQ(text.find('\n'), text.size() - 1);
  }

  TEST(TimeLeft, IsThatOfTheWholeRun)
  {
    // stages take ten times what was expected: 20, 10 and 50 s
    TimeLeft left({2., 1., 5.});
    left.begin(0, 100.);
    EXPECT_TRUE(std::isnan(left.at(0.001, 100.02).of_run));
    EXPECT_NEAR(left.at(0.25, 105.).of_stage, 15., 1e-12);
    EXPECT_NEAR(left.at(0.25, 105.).of_run, 75., 1e-12);
    left.begin(1, 120.);
    EXPECT_NEAR(left.at(0.5, 125.).of_run, 55., 1e-12);
    left.begin(2, 130.);
    EXPECT_NEAR(left.at(0.1, 135.).of_run, 45., 1e-12);
  }

  TEST(TimeLeft, OfStagesWhoseEndIsUnknownIsNotGuessed)
  {
    TimeLeft left({2., 0.});
    left.begin(0, 0.);
    EXPECT_NEAR(left.at(0.25, 5.).of_stage, 15., 1e-12);
    EXPECT_TRUE(std::isnan(left.at(0.25, 5.).of_run));
    left.begin(1, 20.);
    EXPECT_NEAR(left.at(0.5, 21.).of_run, 1., 1e-12);
    // a run that goes on in its second stage knows what that one tells
    TimeLeft resumed({2., 1., 4.});
    resumed.begin(1, 0.);
    EXPECT_NEAR(resumed.at(0.5, 3.).of_run, 3. + 24., 1e-12);
  }

  TEST_F(OutputText, ATerminalHasABarAndWarningsInColour)
  {
    std::ostringstream terminal;
    unsetenv("NO_COLOR");
    {
      RunLog log(directory.string(), MPI_COMM_SELF, terminal, true, 0.);
      log.progress({"perforation", 1, 0.5, 1e-3, "sound", 100, 0.25, 10., 75.});
      log.warning("thin ice");
      setenv("NO_COLOR", "1", 1);
      log.warning("thinner ice");
    }
    unsetenv("NO_COLOR");
    EXPECT_NE(terminal.str().find("\r[#####---------------] perforation: step 1"), std::string::npos);
    EXPECT_NE(terminal.str().find("25.0 %, 1 min 15 s left"), std::string::npos) << terminal.str();
    EXPECT_NE(terminal.str().find("\033[33mwarning:\033[0m thin ice\n"), std::string::npos);
    EXPECT_NE(terminal.str().find("warning: thinner ice\n"), std::string::npos);
    EXPECT_NE(content("log.txt").find("warning: thin ice\n"), std::string::npos);
  }

  TEST_F(OutputText, ProgressIsRefreshedInPlaceOnATerminal)
  {
    std::ostringstream terminal;
    {
      RunLog log(directory.string(), MPI_COMM_SELF, terminal, true, 0.);
      log.progress({"perforation", 1, 0.5, 1e-3, "sound speed", 100, NAN});
      log.progress({"flight", 2, 0.6, 1e-3, "-", 9, NAN});
      log.info("done");
      log.progress({"flight", 3, 0.6, 1e-3, "-", 9, NAN});
    }
    const std::string text = terminal.str();
    EXPECT_EQ(std::count(text.begin(), text.end(), '\n'), 2); // "done", and the end of the pending line
    EXPECT_EQ(text.back(), '\n');
    EXPECT_NE(text.find("\rdone\n"), std::string::npos);
    EXPECT_EQ(text.find('%'), std::string::npos);
    // the file gets the first progress line at once, then one every ten seconds
    EXPECT_NE(content("log.txt").find("perforation: step 1"), std::string::npos);
  }

  TEST_F(OutputText, DirectoryOfAnEarlierRunIsCleared)
  {
    const std::string run = (directory / "deep" / "run").string();
    prepare_output_directory(run, EarlierRun::replaced, MPI_COMM_SELF);
    EXPECT_THROW(prepare_output_directory(run, EarlierRun::refused, MPI_COMM_SELF), InputError);
    // what the manifest lists goes, with folders that are empty then; what it does not list stays, wherever it is
    std::ofstream(run + "/summary.json") << "{}";
    std::ofstream(run + "/notes.txt") << "mine";
    for (const char *name : {"fields/fields-00000.h5", "gauges/a.csv", "../outside.txt"})
      manifest::note(run, name);
    fs::create_directories(run + "/fields");
    fs::create_directories(run + "/gauges");
    fs::create_directories(run + "/checkpoints/000001");
    for (const char *name : {"/fields/fields-00000.h5", "/fields/mine.h5", "/gauges/a.csv",
                             "/checkpoints/000001/rank.h5", "/../outside.txt"})
      std::ofstream(run + name) << "data";
    manifest::note(run, "error_estimate/cell=1/");
    prepare_output_directory(run + "/error_estimate/cell=1", EarlierRun::refused, MPI_COMM_SELF);
    std::ofstream(run + "/error_estimate/cell=1/mine.txt") << "mine";
    prepare_output_directory(run, EarlierRun::replaced, MPI_COMM_SELF);
    for (const char *name :
         {"/summary.json", "/fields/fields-00000.h5", "/gauges", "/checkpoints", "/error_estimate/cell=1/log.txt"})
      EXPECT_FALSE(fs::exists(run + name)) << name;
    for (const char *name : {"/notes.txt", "/fields/mine.h5", "/../outside.txt", "/error_estimate/cell=1/mine.txt"})
      EXPECT_TRUE(fs::exists(run + name)) << name;
  }

  TEST_F(OutputText, ARunWithoutAManifestIsNotReplaced)
  {
    const std::string run = (directory / "old").string();
    prepare_output_directory(run, EarlierRun::refused, MPI_COMM_SELF);
    fs::remove(run + "/manifest.txt");
    EXPECT_THROW(prepare_output_directory(run, EarlierRun::replaced, MPI_COMM_SELF), InputError);
    EXPECT_TRUE(fs::exists(run + "/log.txt"));
  }

  TEST_F(OutputText, ANewRunGoesBesideEarlierOnes)
  {
    const std::string run = (directory / "run").string();
    EXPECT_EQ(free_output_directory(run), run);
    prepare_output_directory(run, EarlierRun::refused, MPI_COMM_SELF);
    EXPECT_EQ(free_output_directory(run), run + "-2");
    EXPECT_EQ(free_output_directory(run + "/"), run + "-2");
    fs::create_directories(run + "-2");
    EXPECT_EQ(free_output_directory(run), run + "-2") << "an empty directory is free";
    std::ofstream(run + "-2/notes.txt") << "mine";
    EXPECT_EQ(free_output_directory(run), run + "-3");
    const auto lock = prepare_output_directory(run, EarlierRun::replaced, MPI_COMM_SELF);
    EXPECT_TRUE(DirectoryLock::is_held(run));
    EXPECT_EQ(free_output_directory(run), run) << "to be refused: another run is writing into it";
  }

  TEST_F(OutputText, ForeignDirectoryIsRefused)
  {
    std::ofstream(directory / "notes.txt") << "mine";
    EXPECT_THROW(prepare_output_directory(directory.string(), EarlierRun::replaced, MPI_COMM_SELF), InputError);
    EXPECT_THROW(prepare_output_directory((directory / "notes.txt").string(), EarlierRun::replaced, MPI_COMM_SELF),
                 InputError);
    std::ofstream(directory / "log.txt") << "of something else";
    EXPECT_THROW(prepare_output_directory(directory.string(), EarlierRun::replaced, MPI_COMM_SELF), InputError);
    EXPECT_EQ(content("log.txt"), "of something else");
  }

  TEST(ProcessUse, IsPlausible)
  {
    const ProcessUse use = process_use(MPI_COMM_SELF);
    EXPECT_GT(use.cpu_s, 0.);
    EXPECT_GT(use.peak_rss_bytes, 1e6);
    EXPECT_LT(use.peak_rss_bytes, 1e12);
  }
} // namespace
