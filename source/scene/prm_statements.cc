// SPDX-License-Identifier: LGPL-2.1-or-later
#include <whipple/error.h>
#include <whipple/scene/prm_statements.h>

#include <fstream>
#include <set>

namespace whipple
{
  namespace
  {
    /// Blanks off both ends, runs of blanks inside made one: as ParameterHandler stores keys and values.
    std::string
    squeeze(const std::string &text)
    {
      std::string squeezed;
      for (const char c : text)
        {
          const bool blank = c == ' ' || c == '\t' || c == '\r' || c == '\n';
          if (!blank)
            squeezed += c;
          else if (!squeezed.empty() && squeezed.back() != ' ')
            squeezed += ' ';
        }
      if (!squeezed.empty() && squeezed.back() == ' ')
        squeezed.pop_back();
      return squeezed;
    }

    /// The text after `word` if the line starts with that word.
    bool
    after_word(const std::string &line, const std::string &word, std::string &rest)
    {
      if (line.compare(0, word.size(), word) != 0 || (line.size() > word.size() && line[word.size()] != ' '))
        return false;
      rest = squeeze(line.substr(word.size()));
      return true;
    }

    std::string
    join(const std::vector<std::string> &path)
    {
      std::string joined;
      for (const std::string &name : path)
        joined += (joined.empty() ? "" : "/") + name;
      return joined;
    }

    /// Next logical line, comment removed and continuations joined; false at the end of the file.
    bool
    next_line(std::istream &input, int &line_number, std::string &line)
    {
      line.clear();
      bool        any = false, more = true;
      std::string physical;
      while (more && std::getline(input, physical))
        {
          ++line_number;
          any                = true;
          const auto comment = physical.find('#');
          physical           = squeeze(physical.substr(0, comment));
          more               = !physical.empty() && physical.back() == '\\';
          if (more)
            physical.pop_back();
          line += physical;
        }
      line = squeeze(line);
      return any;
    }
  } // namespace

  std::vector<PrmStatement>
  read_prm_statements(const std::string &file)
  {
    std::ifstream input(file);
    if (!input)
      throw InputError(file + ": cannot be read; give the path of a scene file (.prm)");

    std::vector<PrmStatement> statements;
    std::vector<std::string>  path;
    std::set<std::string>     names;
    std::string               line, rest;
    for (int number = 0; next_line(input, number, line);)
      {
        const std::string origin = file + ":" + std::to_string(number);
        if (line.empty())
          continue;
        if (after_word(line, "subsection", rest) && !rest.empty())
          path.push_back(rest);
        else if (line == "end")
          {
            if (path.empty())
              throw InputError(origin + ": 'end' without a subsection to close");
            path.pop_back();
          }
        else if (const auto equals = line.find('=');
                 after_word(line.substr(0, equals), "set", rest) && equals != std::string::npos && !rest.empty())
          {
            statements.push_back({origin, join(path), rest, squeeze(line.substr(equals + 1))});
            const PrmStatement &statement = statements.back();
            if (!names.insert(statement.name()).second)
              throw InputError(origin, statement.name(), statement.value, "is set twice; allowed is once");
          }
        else
          throw InputError(origin + ": '" + line +
                           "' is no statement; allowed are 'subsection NAME', 'set KEY = VALUE', 'end' and # comments");
      }
    if (!path.empty())
      throw InputError(file + ": subsection '" + join(path) + "' is not closed; add 'end'");
    return statements;
  }

  PrmStatement
  read_override(const std::string &text)
  {
    const auto        equals = text.find('=');
    const std::string name   = squeeze(text.substr(0, equals));
    const auto        slash  = name.rfind('/');
    PrmStatement      statement{"--set", slash == std::string::npos ? "" : name.substr(0, slash),
                           name.substr(slash == std::string::npos ? 0 : slash + 1), ""};
    if (equals == std::string::npos || statement.key.empty())
      throw InputError("--set '" + text + "': allowed is 'Section/Sub/Name = value'");
    statement.value = squeeze(text.substr(equals + 1));
    return statement;
  }
} // namespace whipple
