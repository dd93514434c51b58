// SPDX-License-Identifier: LGPL-2.1-or-later
#include <whipple/error.h>
#include <whipple/scene/command_line.h>

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

    Run
    parse_run(std::span<const std::string> arguments)
    {
      Run run;
      for (std::size_t i = 0; i < arguments.size(); ++i)
        {
          const std::string &argument = arguments[i];
          if (argument == "-n")
            run.ranks = parse_ranks(value_of(arguments, i, "the number of ranks"));
          else if (argument == "--set")
            run.options.overrides.push_back(parse_override(value_of(arguments, i, "'Section/Sub/Name = value'")));
          else if (argument == "--output")
            run.options.output_directory = value_of(arguments, i, "a directory");
          else if (argument == "--validate")
            run.options.validate_only = true;
          else if (argument.starts_with('-'))
            throw InputError("unknown option '" + argument + "': run takes -n, --set, --output and --validate");
          else if (!run.options.scene_file.empty())
            throw InputError("two scene files, '" + run.options.scene_file + "' and '" + argument +
                             "': run takes one (write --set 'name = value' as one quoted argument)");
          else
            run.options.scene_file = argument;
        }
      if (run.options.scene_file.empty())
        throw InputError("run needs a scene file: whipple run SCENE.prm");
      if (run.options.output_directory.empty())
        run.options.output_directory =
            (std::filesystem::path("output") / std::filesystem::path(run.options.scene_file).stem()).string();
      return run;
    }
  } // namespace

  Command
  parse(std::span<const std::string> arguments)
  {
    if (arguments.empty())
      return Help{};
    const std::string &verb = arguments[0];
    if (verb == "run")
      return parse_run(arguments.subspan(1));
    if (verb == "help" || verb == "--help" || verb == "-h")
      {
        if (arguments.size() > 2)
          throw InputError("help takes one topic: scene, effects or materials");
        return Help{arguments.size() == 2 ? arguments[1] : std::string{}};
      }
    if (verb == "--version")
      return Version{};
    if (verb == "test" || verb == "build")
      throw InputError("'" + verb + "' is a verb of the launcher: ./whipple " + verb);
    throw InputError("unknown verb '" + verb + "': use run or help");
  }
} // namespace whipple::command_line
