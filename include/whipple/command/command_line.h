// SPDX-License-Identifier: LGPL-2.1-or-later
#pragma once

#include <whipple/study/run.h>
#include <whipple/study/study_plan.h>

#include <span>
#include <string>
#include <string_view>
#include <variant>

/// The command line of the program itself (the launcher ./whipple installs and builds first, then passes it on).
namespace whipple::command_line
{
  /// `run SCENE [-n RANKS] [--set 'Section/Sub/Name = value']... [--output DIR] [--validate]`, or
  /// `run --resume DIR [-n RANKS] [--set ...]`
  struct Run
  {
    RunOptions options;
    int        ranks = 0; ///< what -n says; 0: not said
  };

  /// `study STUDY [-n RANKS] [--set ...]... [--output DIR] [--tolerance 'RESULT = 2 %'] [--budget '20 min']
  /// [--any-version] [--validate]`
  struct Study
  {
    StudyOptions options;
  };

  /// `help [TOPIC]`, `--help`, or nothing at all
  struct Help
  {
    std::string topic; ///< empty: overview
  };

  /// `--version`
  struct Version
  {
  };

  using Command = std::variant<Run, Study, Help, Version>;

  /// Understand the arguments after the program's name.
  /// @throws InputError with one line that names what is wrong and what is allowed.
  Command
  parse(std::span<const std::string> arguments);

  /// Text of a help topic: "" (overview), "scene", "effects", "materials", "study".
  /// @throws InputError if there is no such topic.
  std::string
  help(std::string_view topic);
} // namespace whipple::command_line
