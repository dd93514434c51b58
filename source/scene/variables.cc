// SPDX-License-Identifier: LGPL-2.1-or-later
#include <whipple/error.h>
#include <whipple/scene/nearest_name.h>
#include <whipple/scene/variables.h>

#include <algorithm>
#include <cctype>
#include <map>
#include <set>
#include <string>

namespace whipple
{
  namespace
  {
    struct Variable
    {
      PrmStatement definition;
      std::string  value;
    };

    bool
    is_letter(char c)
    {
      return std::isalnum(static_cast<unsigned char>(c)) || c == '_';
    }

    bool
    is_name(const std::string &text)
    {
      return !text.empty() && !std::isdigit(static_cast<unsigned char>(text[0])) &&
             std::all_of(text.begin(), text.end(), is_letter);
    }

    std::string
    without_blanks_at_ends(const std::string &text)
    {
      const auto first = text.find_first_not_of(' ');
      return first == std::string::npos ? "" : text.substr(first, text.find_last_not_of(' ') - first + 1);
    }

    /// "d = 0.32 cm, lower corner = 0 cm, 1 cm" as assignments; a comma begins a new one if a name and '=' follow.
    std::vector<PrmStatement>
    assignments(const PrmStatement &line)
    {
      std::vector<PrmStatement> found;
      std::string               rest = line.value;
      while (!rest.empty())
        {
          const std::size_t comma  = rest.find(',');
          std::string       part   = rest.substr(0, comma);
          const std::size_t equals = part.find('=');
          if (equals != std::string::npos)
            found.push_back({line.origin, variables_section, without_blanks_at_ends(part.substr(0, equals)),
                             without_blanks_at_ends(part.substr(equals + 1))});
          else if (found.empty())
            throw InputError(line.origin, line.name(), line.value, "allowed is 'name = value, name = value'");
          else
            found.back().value += ", " + without_blanks_at_ends(part);
          rest = comma == std::string::npos ? "" : rest.substr(comma + 1);
        }
      return found;
    }

    /// All variables of a scene.
    class Variables
    {
    public:
      void
      define(const PrmStatement &statement)
      {
        if (!is_name(statement.key))
          throw InputError(statement.origin, std::string(variables_section) + '/' + statement.key, statement.value,
                           "no name of a variable; allowed are letters, digits and _, no digit first");
        const std::string value = inserted(statement);
        all_[statement.key]     = {statement, value};
      }

      /// The value of a statement with the values of variables in it.
      std::string
      inserted(const PrmStatement &statement)
      {
        std::string        text;
        const std::string &value = statement.value;
        for (std::size_t i = 0; i < value.size();)
          {
            if (value[i] != '$')
              {
                text += value[i++];
                continue;
              }
            const bool  braces = i + 1 < value.size() && value[i + 1] == '{';
            std::size_t begin = i + (braces ? 2 : 1), end = begin;
            while (end < value.size() && is_letter(value[end]))
              ++end;
            if (braces && (end == value.size() || value[end] != '}'))
              throw InputError(statement.origin, statement.name(), value, "'${' without its '}'");
            text += value_of(value.substr(begin, end - begin), statement);
            i = end + (braces ? 1 : 0);
          }
        return text;
      }

      /// @throws InputError if a variable that the command line has set is used nowhere
      void
      require_used() const
      {
        for (const auto &[name, variable] : all_)
          if (variable.definition.origin == command_line && !used_.contains(name))
            throw InputError(variable.definition.origin, variable.definition.name(), variable.definition.value,
                             "no value of the scene uses $" + name);
      }

    private:
      static constexpr const char *command_line = "--set";

      const std::string &
      value_of(const std::string &name, const PrmStatement &used_in)
      {
        const auto found = all_.find(name);
        if (found == all_.end())
          {
            std::vector<std::string> names;
            for (const auto &[known, variable] : all_)
              names.push_back(known);
            throw InputError(used_in.origin, used_in.name(), used_in.value,
                             "no variable '" + name + "'; " +
                                 (names.empty() ? "the scene defines none ('set Variables = d = 0.32 cm')"
                                                : name_choices(name, names)));
          }
        used_.insert(name);
        return found->second.value;
      }

      std::map<std::string, Variable> all_;
      std::set<std::string>           used_;
    };

    bool
    defines_variables(const PrmStatement &statement)
    {
      return statement.section == variables_section || statement.name() == variables_section;
    }

    /// Definitions in their order, of each name the last.
    std::vector<PrmStatement>
    definitions(const std::vector<PrmStatement> &statements)
    {
      std::vector<PrmStatement> found;
      for (const PrmStatement &statement : statements)
        if (defines_variables(statement))
          for (PrmStatement &one :
               statement.section == variables_section ? std::vector{statement} : assignments(statement))
            {
              const auto earlier = std::find_if(found.begin(), found.end(),
                                                [&one](const PrmStatement &other) { return other.key == one.key; });
              if (earlier == found.end())
                found.push_back(std::move(one));
              else
                *earlier = std::move(one);
            }
      return found;
    }
  } // namespace

  void
  substitute_variables(std::vector<PrmStatement> &statements)
  {
    Variables variables;
    for (const PrmStatement &definition : definitions(statements))
      variables.define(definition);
    std::erase_if(statements, defines_variables);
    for (PrmStatement &statement : statements)
      statement.value = variables.inserted(statement);
    variables.require_used();
  }
} // namespace whipple
