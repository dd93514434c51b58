// SPDX-License-Identifier: LGPL-2.1-or-later
#pragma once

#include <whipple/scene/prm_statements.h>

#include <functional>
#include <memory>
#include <string>
#include <vector>

namespace dealii
{
  class ParameterHandler; // its header is long, and all rooms that read scenes would include it
}

namespace whipple
{
  /// The entries of a scene: declared with default and documentation, assigned from statements, read back by the
  /// sections. A dealii::ParameterHandler holds and prints them; this class adds where each value came from, so
  /// that whatever is wrong with it is reported in one line.
  class SceneParameters
  {
  public:
    /// @param file the .prm, for messages about entries that it does not set
    explicit SceneParameters(std::string file);
    ~SceneParameters();

    /// Declare an entry. An empty default means "not given".
    void
    declare(const std::string &section, const std::string &key, const std::string &default_value,
            const std::string &documentation);

    /// Set the entry of a statement.
    /// @throws InputError if no such section or entry is declared; names the ones that are.
    void
    assign(const PrmStatement &statement);

    /// Value as text.
    std::string
    get(const std::string &section, const std::string &key);

    /// Put the effective value in place of what the user left open.
    void
    replace(const std::string &section, const std::string &key, const std::string &value);

    /// @throws InputError always: "FILE:LINE: SECTION/KEY = 'VALUE': ALLOWED".
    [[noreturn]] void
    reject(const std::string &section, const std::string &key, const std::string &allowed);

    /// All entries as a .prm with their documentation, but for sections ("Stages/debris") for which `keep` is false.
    std::string
    print(const std::function<bool(const std::string &section)> &keep) const;

  private:
    struct Entry
    {
      std::string section, key, origin;
    };

    Entry *
    find(const std::string &section, const std::string &key);

    [[noreturn]] void
    reject_unknown(const PrmStatement &statement) const;

    void
    enter(const std::string &section);
    void
    leave(const std::string &section);

    std::string                               file_;
    std::unique_ptr<dealii::ParameterHandler> handler_;
    std::vector<Entry>                        entries_;
  };
} // namespace whipple
