// SPDX-License-Identifier: LGPL-2.1-or-later
#pragma once

#include <istream>
#include <string>
#include <vector>

namespace whipple
{
  /// One "set KEY = VALUE" of a .prm file or of the command line.
  struct PrmStatement
  {
    std::string origin;  ///< "prm/whipple_shield.prm:12" or "--set"
    std::string section; ///< "Bodies/sphere"; empty at the top
    std::string key;     ///< "Diameter"
    std::string value;   ///< "0.32 cm"

    /// "Bodies/sphere/Diameter"
    std::string
    name() const
    {
      return section.empty() ? key : section + "/" + key;
    }
  };

  /// All assignments of a .prm file (deal.II ParameterHandler's format: subsection, set, end, comments from '#',
  /// a backslash at the end of a line continues it), each with the line it stands in. `include FILE` stands for the
  /// statements of another file, in the section where it stands; its path counts from the file that includes it. What
  /// an included file sets may be set again after it.
  /// @throws InputError if a file cannot be read or includes itself, a line is no statement, subsections are not
  /// closed, or a key is set twice.
  std::vector<PrmStatement>
  read_prm_statements(const std::string &file);

  /// The same of a text. @param name that errors call it by
  std::vector<PrmStatement>
  read_prm_statements(std::istream &input, const std::string &name);

  /// "Section/Sub/Name = value" as an assignment.
  /// @throws InputError if there is no '=' or no name.
  PrmStatement
  read_override(const std::string &text);
} // namespace whipple
