// SPDX-License-Identifier: LGPL-2.1-or-later
#include <whipple/error.h>
#include <whipple/scene/nearest_name.h>
#include <whipple/scene/parameters.h>

#include <deal.II/base/parameter_handler.h>

#include <algorithm>
#include <sstream>

namespace whipple
{
  SceneParameters::SceneParameters(std::string file)
    : file_(std::move(file))
    , handler_(std::make_unique<dealii::ParameterHandler>())
  {
  }

  SceneParameters::~SceneParameters() = default;

  void
  SceneParameters::declare(const std::string &section, const std::string &key, const std::string &default_value,
                           const std::string &documentation)
  {
    enter(section);
    handler_->declare_entry(key, default_value, dealii::Patterns::Anything(), documentation);
    leave(section);
    entries_.push_back({section, key, file_});
  }

  void
  SceneParameters::assign(const PrmStatement &statement)
  {
    Entry *entry = find(statement.section, statement.key);
    if (!entry)
      reject_unknown(statement);
    entry->origin = statement.origin;
    replace(statement.section, statement.key, statement.value);
  }

  std::string
  SceneParameters::get(const std::string &section, const std::string &key)
  {
    enter(section);
    const std::string value = handler_->get(key);
    leave(section);
    return value;
  }

  void
  SceneParameters::replace(const std::string &section, const std::string &key, const std::string &value)
  {
    enter(section);
    handler_->set(key, value);
    leave(section);
  }

  void
  SceneParameters::reject(const std::string &section, const std::string &key, const std::string &allowed)
  {
    constexpr std::size_t longest = 300; // of a value that a line can show
    std::string           value   = get(section, key);
    if (value.size() > longest)
      value.replace(longest, std::string::npos, " ...");
    throw InputError(find(section, key)->origin, section.empty() ? key : section + "/" + key, value, allowed);
  }

  std::string
  SceneParameters::print(const std::function<bool(const std::string &section)> &keep) const
  {
    std::stringstream all;
    handler_->print_parameters(all,
                               dealii::ParameterHandler::OutputStyle(dealii::ParameterHandler::PRM |
                                                                     dealii::ParameterHandler::KeepDeclarationOrder));
    std::string              text;
    std::vector<std::string> path;
    std::size_t              dropped_at = 0; // depth of the section that is left out; 0: none
    for (std::string line; std::getline(all, line);)
      {
        const std::string statement = line.substr(std::min(line.find_first_not_of(' '), line.size()));
        if (statement.starts_with("subsection "))
          {
            path.push_back((path.empty() ? "" : path.back() + '/') + statement.substr(11));
            if (dropped_at == 0 && !keep(path.back()))
              dropped_at = path.size();
          }
        if (dropped_at == 0)
          text += line + '\n';
        if (statement == "end")
          {
            if (dropped_at == path.size())
              dropped_at = 0;
            path.pop_back();
          }
      }
    return text;
  }

  SceneParameters::Entry *
  SceneParameters::find(const std::string &section, const std::string &key)
  {
    const auto entry = std::find_if(entries_.begin(), entries_.end(),
                                    [&](const Entry &e) { return e.section == section && e.key == key; });
    return entry == entries_.end() ? nullptr : &*entry;
  }

  void
  SceneParameters::reject_unknown(const PrmStatement &statement) const
  {
    std::vector<std::string> keys, sections;
    for (const Entry &entry : entries_)
      {
        if (entry.section == statement.section)
          keys.push_back(entry.key);
        if (!entry.section.empty() && std::find(sections.begin(), sections.end(), entry.section) == sections.end())
          sections.push_back(entry.section);
      }
    const bool known = !keys.empty();
    throw InputError(statement.origin, statement.name(), statement.value,
                     known ? "no such key; " + name_choices(statement.key, keys)
                           : "no such section; " + name_choices(statement.section, sections));
  }

  void
  SceneParameters::enter(const std::string &section)
  {
    std::istringstream names(section);
    for (std::string name; std::getline(names, name, '/');)
      handler_->enter_subsection(name);
  }

  void
  SceneParameters::leave(const std::string &section)
  {
    std::istringstream names(section);
    for (std::string name; std::getline(names, name, '/');)
      handler_->leave_subsection();
  }
} // namespace whipple
