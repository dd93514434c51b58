// SPDX-License-Identifier: LGPL-2.1-or-later
#include <whipple/error.h>
#include <whipple/scene/prm_statements.h>

#include <algorithm>
#include <filesystem>
#include <fstream>
#include <map>
#include <system_error>
#include <utility>

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

    /// @throws InputError if a text holds a control character: it would go into logs, plots and messages.
    void
    reject_control_characters(const std::string &origin, const std::string &text)
    {
      const auto is_control = [](unsigned char c) { return c < 0x20 || c == 0x7f; };
      const auto found      = std::find_if(text.begin(), text.end(), is_control);
      if (found == text.end())
        return;
      constexpr char    digits[] = "0123456789abcdef";
      const auto        c        = static_cast<unsigned char>(*found);
      const std::string code{'0', 'x', digits[c / 16], digits[c % 16]};
      throw InputError(origin + ": control character " + code + " at column " +
                       std::to_string(found - text.begin() + 1) + "; allowed is plain text (UTF-8)");
    }

    /// A scene is a file of text and not what never ends or is something else; without the mark that some editors put
    /// at the start of UTF-8.
    std::ifstream
    open_text(const std::string &file)
    {
      constexpr std::uintmax_t largest = 16 << 20; // bytes
      std::error_code          error;
      const auto               status = std::filesystem::status(file, error);
      if (std::filesystem::exists(status) && status.type() != std::filesystem::file_type::regular)
        throw InputError(file + ": is no file (a folder, pipe or device); give the path of a scene file (.prm)");
      std::ifstream input(file, std::ios::binary);
      if (!input)
        throw InputError(file + ": cannot be read; give the path of a scene file (.prm)");
      if (const std::uintmax_t size = std::filesystem::file_size(file, error); !error && size > largest)
        throw InputError(file + ": has " + std::to_string(size) + " bytes; allowed are scene files (.prm) of at most " +
                         std::to_string(largest));
      constexpr char mark[] = "\xef\xbb\xbf";
      char           first[3];
      if (!input.read(first, 3) || !std::equal(first, first + 3, mark))
        {
          input.clear();
          input.seekg(0);
        }
      return input;
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
    next_line(std::istream &input, const std::string &file, int &line_number, std::string &line)
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
          reject_control_characters(file + ":" + std::to_string(line_number), physical);
          more = !physical.empty() && physical.back() == '\\';
          if (more)
            physical.pop_back();
          line += physical;
        }
      line = squeeze(line);
      return any;
    }

    /// Statements of a file and of those that it includes.
    class Reader
    {
    public:
      /// @param section the one in which an including file stands
      void
      read(std::istream &input, const std::string &file, const std::vector<std::string> &section)
      {
        open_files_.push_back(file);
        std::vector<std::string> path = section;
        std::string              line, rest;
        for (int number = 0; next_line(input, file, number, line);)
          {
            const std::string origin = file + ":" + std::to_string(number);
            if (line.empty())
              continue;
            if (after_word(line, "subsection", rest) && !rest.empty())
              path.push_back(rest);
            else if (line == "end")
              {
                if (path.size() == section.size())
                  throw InputError(origin + ": 'end' without a subsection to close");
                path.pop_back();
              }
            else if (after_word(line, "include", rest) && !rest.empty())
              include(origin, rest, path);
            else if (const auto equals = line.find('=');
                     after_word(line.substr(0, equals), "set", rest) && equals != std::string::npos && !rest.empty())
              set({origin, join(path), rest, squeeze(line.substr(equals + 1))});
            else
              throw InputError(origin + ": '" + line +
                               "' is no statement; allowed are 'subsection NAME', 'set KEY = VALUE', 'end', "
                               "'include FILE' and # comments");
          }
        if (path.size() != section.size())
          throw InputError(file + ": subsection '" + join(path) + "' is not closed; add 'end'");
        open_files_.pop_back();
      }

      std::vector<PrmStatement>
      statements() &&
      {
        return std::move(statements_);
      }

    private:
      void
      include(const std::string &origin, const std::string &name, const std::vector<std::string> &path)
      {
        const std::string file = (std::filesystem::path(open_files_.back()).parent_path() / name).string();
        for (const std::string &open : open_files_)
          if (std::error_code error; std::filesystem::equivalent(open, file, error))
            throw InputError(origin + ": include " + name + ": the file includes itself");
        std::ifstream input;
        try
          {
            input = open_text(file);
          }
        catch (const InputError &error)
          {
            throw InputError(origin + ": include " + name + ": " + error.what());
          }
        read(input, file, path);
      }

      /// A file may set again what a file that it includes has set.
      void
      set(PrmStatement statement)
      {
        const std::string name  = statement.name();
        const std::size_t depth = open_files_.size();
        if (const auto earlier = depth_.find(name); earlier != depth_.end())
          {
            if (earlier->second <= depth)
              throw InputError(statement.origin, name, statement.value, "is set twice; allowed is once");
            std::erase_if(statements_, [&name](const PrmStatement &other) { return other.name() == name; });
          }
        depth_[name] = depth;
        statements_.push_back(std::move(statement));
      }

      std::vector<PrmStatement>          statements_;
      std::map<std::string, std::size_t> depth_;      ///< of the file that has set a name
      std::vector<std::string>           open_files_; ///< each included by the one before
    };
  } // namespace

  std::vector<PrmStatement>
  read_prm_statements(const std::string &file)
  {
    std::ifstream input = open_text(file);
    return read_prm_statements(input, file);
  }

  std::vector<PrmStatement>
  read_prm_statements(std::istream &input, const std::string &file)
  {
    Reader reader;
    reader.read(input, file, {});
    return std::move(reader).statements();
  }

  PrmStatement
  read_override(const std::string &text)
  {
    reject_control_characters("--set", squeeze(text));
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
