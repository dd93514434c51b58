// SPDX-License-Identifier: LGPL-2.1-or-later
#include <whipple/command/command_line.h>
#include <whipple/error.h>

#include <charconv>
#include <filesystem>

namespace whipple::command_line
{
  namespace
  {
    constexpr int most_ranks = 4096; // a typo, not a machine

    /// The value that follows an option.
    const std::string &
    value_of(std::span<const std::string> arguments, std::size_t &i, const char *what)
    {
      if (i + 1 >= arguments.size())
        throw InputError("option " + arguments[i] + " needs a value: " + what);
      return arguments[++i];
    }

    int
    parse_ranks(const std::string &text)
    {
      int        ranks            = 0;
      const auto end              = text.data() + text.size();
      const auto [stopped, error] = std::from_chars(text.data(), end, ranks);
      if (error != std::errc{} || stopped != end || ranks < 1 || ranks > most_ranks)
        throw InputError("command line", "-n", text, "a number of ranks from 1 to " + std::to_string(most_ranks));
      return ranks;
    }

    std::string
    parse_override(const std::string &text)
    {
      const std::size_t equals = text.find('=');
      if (equals == std::string::npos || text.find_first_not_of(' ') == equals)
        throw InputError("command line", "--set", text, "write 'Section/Sub/Name = value'");
      return text;
    }

    /// Where results go unless --output says otherwise.
    std::string
    default_output(const std::string &file)
    {
      return (std::filesystem::path("output") / std::filesystem::path(file).stem()).string();
    }

    /// The one file that a verb takes.
    void
    take_file(std::string &file, const std::string &argument, const std::string &verb, const std::string &what)
    {
      if (argument.starts_with('-'))
        throw InputError("unknown option '" + argument + "': " + what);
      if (!file.empty())
        throw InputError((verb == "run" ? "two scene files, '" : "two study files, '") + file + "' and '" + argument +
                         "': " + verb + " takes one (write --set 'name = value' as one quoted argument)");
      file = argument;
    }

    /// Make a run go on in its own directory, with the parameters it had.
    void
    resume(const std::string &directory, RunOptions &options)
    {
      if (!options.scene_file.empty())
        throw InputError("command line", "--resume", directory,
                         "takes no scene file beside it, the run has its own ('" + options.scene_file + "' is given)");
      if (!options.output_directory.empty())
        throw InputError("command line", "--resume", directory,
                         "takes no --output: the run goes on in its own directory");
      options.resume           = true;
      options.output_directory = directory;
      options.scene_file       = (std::filesystem::path(directory) / "parameters.prm").string();
      if (!std::filesystem::exists(options.scene_file))
        throw InputError("command line", "--resume", directory, "is no directory of a run: it has no parameters.prm");
    }

    Run
    parse_run(std::span<const std::string> arguments)
    {
      Run         run;
      RunOptions &options = run.options;
      std::string resumed;
      for (std::size_t i = 0; i < arguments.size(); ++i)
        {
          const std::string &argument = arguments[i];
          if (argument == "-n")
            run.ranks = parse_ranks(value_of(arguments, i, "the number of ranks"));
          else if (argument == "--set")
            options.overrides.push_back(parse_override(value_of(arguments, i, "'Section/Sub/Name = value'")));
          else if (argument == "--output")
            options.output_directory = value_of(arguments, i, "a directory");
          else if (argument == "--resume")
            resumed = value_of(arguments, i, "the directory of a run");
          else if (argument == "--overwrite")
            options.overwrite = true;
          else if (argument == "--validate")
            options.validate_only = true;
          else if (argument == "--effects-report")
            options.effects_report = true;
          else
            take_file(options.scene_file, argument, "run",
                      "run takes -n, --set, --output, --overwrite, --resume, --validate and --effects-report");
        }
      if (!resumed.empty())
        resume(resumed, options);
      if (options.scene_file.empty())
        throw InputError("run needs a scene file: whipple run SCENE.prm");
      if (options.output_directory.empty())
        options.output_directory = default_output(options.scene_file);
      return run;
    }

    /// The words as a shell takes them.
    std::string
    quoted(std::span<const std::string> arguments)
    {
      std::string text = "./whipple";
      for (const std::string &argument : arguments)
        {
          if (!argument.empty() && argument.find_first_of(" \t\n'\"\\$`;|&()*?[]{}<>=#~!") == std::string::npos)
            {
              text += ' ' + argument;
              continue;
            }
          text += " '";
          for (const char c : argument)
            text += c == '\'' ? std::string("'\\''") : std::string(1, c);
          text += '\'';
        }
      return text;
    }

    /// Options written as --output=DIR, in two words.
    std::vector<std::string>
    separated(std::span<const std::string> arguments)
    {
      std::vector<std::string> words;
      for (const std::string &argument : arguments)
        {
          const std::size_t equals = argument.find('=');
          if (!argument.starts_with("--") || equals == std::string::npos)
            {
              words.push_back(argument);
              continue;
            }
          words.push_back(argument.substr(0, equals));
          words.push_back(argument.substr(equals + 1));
        }
      return words;
    }

    Study
    parse_study(std::span<const std::string> words)
    {
      Study         study;
      StudyOptions &options = study.options;
      options.command       = quoted(words);
      const auto arguments  = words.subspan(1);
      for (std::size_t i = 0; i < arguments.size(); ++i)
        {
          const std::string &argument = arguments[i];
          if (argument == "-n")
            options.ranks = parse_ranks(value_of(arguments, i, "the number of ranks"));
          else if (argument == "--set")
            options.overrides.push_back(parse_override(value_of(arguments, i, "'Section/Sub/Name = value'")));
          else if (argument == "--output")
            options.output_directory = value_of(arguments, i, "a directory");
          else if (argument == "--tolerance")
            options.tolerance = value_of(arguments, i, "'RESULT = 2 %'");
          else if (argument == "--budget")
            options.budget = value_of(arguments, i, "'20 min'");
          else if (argument == "--any-version")
            options.any_version = true;
          else if (argument == "--validate")
            options.validate_only = true;
          else
            take_file(options.file, argument, "study",
                      "study takes -n, --set, --output, --tolerance, --budget, --any-version and --validate");
        }
      if (options.file.empty())
        throw InputError("study needs a file: whipple study STUDY.prm");
      if (options.output_directory.empty())
        options.output_directory = default_output(options.file);
      return study;
    }
  } // namespace

  Command
  parse(std::span<const std::string> given)
  {
    const std::vector<std::string>     words = separated(given);
    const std::span<const std::string> arguments(words);
    if (arguments.empty())
      return Help{};
    const std::string &verb = arguments[0];
    if (verb == "run" || verb == "study")
      for (const std::string &argument : arguments.subspan(1))
        if (argument == "--help" || argument == "-h")
          return Help{};
    if (verb == "run")
      return parse_run(arguments.subspan(1));
    if (verb == "study")
      return parse_study(arguments);
    if (verb == "help" || verb == "--help" || verb == "-h")
      {
        if (arguments.size() > 2)
          throw InputError("help takes one topic, such as scene, study or effects");
        return Help{arguments.size() == 2 ? arguments[1] : std::string{}};
      }
    if (verb == "--version")
      return Version{};
    if (verb == "test" || verb == "build" || verb == "plot" || verb == "report")
      throw InputError("'" + verb + "' is a verb of the launcher: ./whipple " + verb);
    throw InputError("unknown verb '" + verb + "': use run, study or help");
  }
} // namespace whipple::command_line
