// SPDX-License-Identifier: LGPL-2.1-or-later
#include <whipple/command/command_line.h>
#include <whipple/error.h>

#include <gtest/gtest.h>

#include <string>
#include <vector>

namespace
{
  using namespace whipple;

  command_line::Run
  parse_run(std::vector<std::string> arguments)
  {
    arguments.insert(arguments.begin(), "run");
    return std::get<command_line::Run>(command_line::parse(arguments));
  }

  TEST(CommandLine, RunWithEverything)
  {
    const auto run = parse_run(
        {"prm/shield.prm", "-n", "3", "--set", "A/B = 1 cm", "--output", "some dir", "--set", "C = d", "--validate"});
    EXPECT_EQ(run.ranks, 3);
    EXPECT_EQ(run.options.scene_file, "prm/shield.prm");
    EXPECT_EQ(run.options.overrides, (std::vector<std::string>{"A/B = 1 cm", "C = d"}));
    EXPECT_EQ(run.options.output_directory, "some dir");
    EXPECT_TRUE(run.options.validate_only);
  }

  TEST(CommandLine, RunDefaults)
  {
    const auto run = parse_run({"a/b/shield.v2.prm"});
    EXPECT_EQ(run.ranks, 0);
    EXPECT_EQ(run.options.output_directory, "output/shield.v2");
    EXPECT_FALSE(run.options.validate_only);
    EXPECT_TRUE(run.options.overrides.empty());
  }

  TEST(CommandLine, StudyWithEverything)
  {
    const std::vector<std::string> words{"study",         "prm/a.prm",   "-n",      "2",        "--set",
                                         "A = b",         "--tolerance", "x = 2 %", "--budget", "20 min",
                                         "--any-version", "--validate"};
    const auto                     options = std::get<command_line::Study>(command_line::parse(words)).options;
    EXPECT_EQ(options.file, "prm/a.prm");
    EXPECT_EQ(options.output_directory, "output/a");
    EXPECT_EQ(options.ranks, 2);
    EXPECT_EQ(options.overrides, (std::vector<std::string>{"A = b"}));
    EXPECT_EQ(options.tolerance, "x = 2 %");
    EXPECT_EQ(options.budget, "20 min");
    EXPECT_TRUE(options.any_version);
    EXPECT_TRUE(options.validate_only);
    EXPECT_EQ(options.command, "./whipple study prm/a.prm -n 2 --set 'A = b' --tolerance 'x = 2 %' --budget '20 min' "
                               "--any-version --validate");
  }

  TEST(CommandLine, ValuesMayFollowAnEqualsSign)
  {
    const auto run = parse_run({"a.prm", "--output=some dir", "--set=A/B = 1 cm"});
    EXPECT_EQ(run.options.output_directory, "some dir");
    EXPECT_EQ(run.options.overrides, (std::vector<std::string>{"A/B = 1 cm"}));
  }

  TEST(CommandLine, HelpWhereverItIsAskedFor)
  {
    for (const std::vector<std::string> &words :
         {std::vector<std::string>{"run", "--help"}, {"run", "a.prm", "-h"}, {"study", "--help"}, {"help", "run"}})
      EXPECT_TRUE(std::holds_alternative<command_line::Help>(command_line::parse(words))) << words[1];
  }

  TEST(CommandLine, TheCommandOfAStudyPastesSafely)
  {
    const std::vector<std::string> words{"study", "a'b $(c).prm", "--set", "A = `d`"};
    EXPECT_EQ(std::get<command_line::Study>(command_line::parse(words)).options.command,
              "./whipple study 'a'\\''b $(c).prm' --set 'A = `d`'");
  }

  TEST(CommandLine, OtherVerbs)
  {
    const std::vector<std::string> none, topic{"help", "effects"}, version{"--version"};
    EXPECT_TRUE(std::holds_alternative<command_line::Help>(command_line::parse(none)));
    EXPECT_EQ(std::get<command_line::Help>(command_line::parse(topic)).topic, "effects");
    EXPECT_TRUE(std::holds_alternative<command_line::Version>(command_line::parse(version)));
  }

  TEST(CommandLine, WrongInputIsOneLine)
  {
    const std::vector<std::vector<std::string>> wrong{{"run"},
                                                      {"run", "a.prm", "b.prm"},
                                                      {"run", "a.prm", "-n", "-1"},
                                                      {"run", "a.prm", "-n", "2x"},
                                                      {"run", "a.prm", "-n"},
                                                      {"run", "a.prm", "--set", " = 3"},
                                                      {"run", "a.prm", "--fast"},
                                                      {"study"},
                                                      {"study", "a.prm", "b.prm"},
                                                      {"study", "a.prm", "--tolerance"},
                                                      {"study", "a.prm", "--fast"},
                                                      {"help", "scene", "effects"},
                                                      {"test"},
                                                      {"sing"}};
    for (const auto &arguments : wrong)
      try
        {
          command_line::parse(arguments);
          FAIL() << arguments.front() << " accepted";
        }
      catch (const InputError &error)
        {
          EXPECT_EQ(std::string(error.what()).find('\n'), std::string::npos);
        }
    EXPECT_THROW(command_line::help("weather"), InputError);
  }
} // namespace
