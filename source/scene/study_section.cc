// SPDX-License-Identifier: LGPL-2.1-or-later
#include <whipple/error.h>
#include <whipple/scene/nearest_name.h>
#include <whipple/scene/section.h>
#include <whipple/scene/study_section.h>

#include <algorithm>
#include <filesystem>
#include <set>

namespace whipple
{
  namespace
  {
    const std::string path = "Study";

    /// Parts of a text between separators, blanks trimmed; a part may be empty, an empty text has no parts.
    std::vector<std::string>
    split(const std::string &text, char separator)
    {
      std::vector<std::string> parts;
      for (std::size_t begin = 0; !text.empty() && begin <= text.size();)
        {
          const std::size_t end   = std::min(text.find(separator, begin), text.size());
          const std::size_t first = std::min(text.find_first_not_of(' ', begin), end);
          const std::size_t last  = first < end ? text.find_last_not_of(' ', end - 1) + 1 : end;
          parts.push_back(text.substr(first, last - first));
          begin = end + 1;
        }
      return parts;
    }

    std::string
    origin_of(const std::vector<PrmStatement> &statements, const std::string &name, const std::string &otherwise)
    {
      for (const PrmStatement &statement : statements)
        if (statement.name() == name)
          return statement.origin;
      return otherwise;
    }

    void
    declare_axis(SceneSection section)
    {
      section.declare("Parameter", "", "Section/Key of the scene, several separated by ';', or ranks");
      section.declare("Values", "", "separated by '|', the parts of each by ';'");
      section.declare("Labels", "", "names of the values, separated by '|'");
      section.declare("Base", "", "label of the value others are compared with");
    }

    void
    declare_study(SceneSection section)
    {
      section.declare("Scene", "", "scene file, relative to this file; not given: this file");
      section.declare("Overrides", "", "Section/Key = value for every run, separated by '|'");
      section.declare("Axes", "", "names of the axes; each has its subsection");
      section.declare("Combination", "product", "product | one at a time");
      section.declare("Leave out", "", "points of a product that are not run: AXIS = LABEL, ... | ...");
      section.declare("Repeats", "1", "how often each point is run");
      section.declare("Results", "", "place/quantity, ... for tables and plots; not given: all");
    }

    void
    read_cells(const SceneSection &section, StudyAxis &axis)
    {
      const auto found = std::find(axis.parameters.begin(), axis.parameters.end(), cell_parameter);
      if (found == axis.parameters.end())
        return;
      std::set<double> cells;
      for (StudyValue &value : axis.values)
        {
          value.cell = section.parse("Values", value.parts[found - axis.parameters.begin()], units::length);
          if (!(*value.cell > 0) || !cells.insert(*value.cell).second)
            section.reject("Values", "cells must be > 0 cm and differ from one another");
        }
      const auto finer = [](const StudyValue &a, const StudyValue &b) { return *a.cell < *b.cell; };
      axis.base        = std::min_element(axis.values.begin(), axis.values.end(), finer) - axis.values.begin();
    }

    void
    read_labels(const SceneSection &section, StudyAxis &axis)
    {
      const std::vector<std::string> labels = split(section.text("Labels"), '|');
      if (!labels.empty() && labels.size() != axis.values.size())
        section.reject("Labels", "allowed is one for each of the " + std::to_string(axis.values.size()) + " values");
      std::set<std::string> used;
      for (std::size_t i = 0; i < axis.values.size(); ++i)
        {
          std::string &label = axis.values[i].label;
          if (!labels.empty())
            label = labels[i];
          else
            for (const std::string &part : axis.values[i].parts)
              label += (label.empty() ? "" : " + ") + part;
          const char *key = labels.empty() ? "Values" : "Labels";
          if (label.empty() || label.find_first_of(",=") != std::string::npos)
            section.reject(key, "'" + label + "' is no label; give Labels without commas and '='");
          if (!used.insert(label).second)
            section.reject(key, "'" + label + "' is there twice; allowed is once");
        }
    }

    void
    check_ranks(const SceneSection &section, const StudyAxis &axis)
    {
      for (std::size_t p = 0; p < axis.parameters.size(); ++p)
        if (axis.parameters[p] == ranks_parameter)
          for (const StudyValue &value : axis.values)
            {
              const std::string &text = value.parts[p];
              if (text.empty() || text.size() > 4 || text[0] == '0' ||
                  text.find_first_not_of("0123456789") != std::string::npos)
                section.reject("Values", "'" + text + "' is no number of ranks; allowed are 1 to 9999");
            }
    }

    StudyAxis
    read_axis(const SceneSection &section, const std::string &name)
    {
      StudyAxis axis;
      axis.name = name;
      if (!section.given("Parameter"))
        section.reject("Parameter",
                       "must be given; allowed are parameters of the scene, 'Mesh/Finest cell', and ranks");
      axis.parameters = split(section.text("Parameter"), ';');
      for (const std::string &part : split(section.text("Values"), '|'))
        {
          StudyValue value;
          value.parts = split(part, ';');
          if (value.parts.size() != axis.parameters.size())
            section.reject("Values", "'" + part + "' has " + std::to_string(value.parts.size()) +
                                         " parts; allowed is one for each parameter, separated by ';'");
          axis.values.push_back(value);
        }
      if (axis.values.empty())
        section.reject("Values", "must be given; allowed are values of the parameter, separated by '|'");
      read_labels(section, axis);
      read_cells(section, axis);
      check_ranks(section, axis);
      return axis;
    }

    /// Names that can be subsections and stand in "Leave out".
    void
    check_axis_names(const SceneSection &section, const std::vector<std::string> &names)
    {
      if (names.empty())
        section.reject("Axes", "must be given; allowed are one or more names, each with its subsection");
      for (const std::string &name : names)
        {
          if (name.find_first_of("/=|;") != std::string::npos)
            section.reject("Axes", "'" + name + "' is no name; allowed are names without / = | ;");
          if (std::count(names.begin(), names.end(), name) > 1)
            section.reject("Axes", "'" + name + "' is listed twice; allowed is once");
        }
    }

    void
    check_parameters(const SceneSection &section, const std::vector<StudyAxis> &axes)
    {
      std::set<std::string> moved;
      for (const StudyAxis &axis : axes)
        for (const std::string &parameter : axis.parameters)
          if (!moved.insert(parameter).second)
            section.reject("Axes", "'" + parameter + "' is moved twice, also by '" + axis.name + "'; allowed is once");
    }

    std::vector<PrmStatement>
    read_overrides(const SceneSection &section, const std::string &origin)
    {
      std::vector<PrmStatement> overrides;
      for (const std::string &text : split(section.text("Overrides"), '|'))
        {
          if (text.find('=') == std::string::npos)
            section.reject("Overrides", "'" + text + "': allowed is Section/Key = value, several separated by '|'");
          overrides.push_back(read_override(text));
          overrides.back().origin = origin;
        }
      return overrides;
    }

    std::vector<StudyChoice>
    read_left_out(const SceneSection &section, const std::vector<StudyAxis> &axes, const std::string &origin)
    {
      const std::string        key = "Leave out";
      std::vector<std::string> names;
      for (const StudyAxis &axis : axes)
        names.push_back(axis.name);
      std::vector<StudyChoice> all;
      for (const std::string &part : split(section.text(key), '|'))
        {
          StudyChoice choice;
          for (const std::string &pair : split_names(part))
            {
              const std::vector<std::string> words = split(pair, '=');
              if (words.size() != 2)
                section.reject(key, "'" + pair + "': allowed is AXIS = LABEL");
              const std::size_t axis = section.name_index(key, words[0], names);
              choice.emplace_back(axis, axes[axis].index_of(words[1], origin, path + "/" + key));
            }
          if (choice.empty())
            section.reject(key, "allowed is AXIS = LABEL, ... | ...");
          all.push_back(choice);
        }
      return all;
    }
  } // namespace

  std::size_t
  StudyAxis::index_of(const std::string &label, const std::string &where, const std::string &key) const
  {
    std::vector<std::string> labels;
    for (const StudyValue &value : values)
      labels.push_back(value.label);
    const auto found = std::find(labels.begin(), labels.end(), label);
    if (found == labels.end())
      throw InputError(where, key, label, "axis '" + name + "' has no such label; " + name_choices(label, labels));
    return found - labels.begin();
  }

  std::optional<std::size_t>
  StudySection::cell_axis() const
  {
    for (std::size_t a = 0; a < axes.size(); ++a)
      if (axes[a].is_cell_axis())
        return a;
    return std::nullopt;
  }

  bool
  belongs_to_study(const PrmStatement &statement)
  {
    return statement.section == path || statement.section.starts_with(path + "/");
  }

  std::optional<StudySection>
  read_study_section(const std::string &file, const std::vector<PrmStatement> &statements)
  {
    if (std::none_of(statements.begin(), statements.end(), belongs_to_study))
      return std::nullopt;
    SceneParameters    parameters(file);
    const SceneSection section(parameters, path);
    declare_study(section);
    for (const PrmStatement &statement : statements)
      if (statement.section == path)
        parameters.assign(statement);
    const std::vector<std::string> names = section.list("Axes");
    check_axis_names(section, names);
    for (const std::string &name : names)
      declare_axis(SceneSection(parameters, path + "/" + name));
    for (const PrmStatement &statement : statements)
      if (belongs_to_study(statement) && statement.section != path)
        parameters.assign(statement);

    StudySection study;
    study.scene_file = file;
    if (section.given("Scene"))
      study.scene_file = (std::filesystem::path(file).parent_path() / section.text("Scene")).lexically_normal();
    study.overrides = read_overrides(section, origin_of(statements, path + "/Overrides", file));
    for (const std::string &name : names)
      {
        const SceneSection axis(parameters, path + "/" + name);
        study.axes.push_back(read_axis(axis, name));
        study.axes.back().origin = origin_of(statements, path + "/" + name + "/Values", file);
        if (axis.given("Base"))
          study.axes.back().base = study.axes.back().index_of(
              axis.text("Base"), origin_of(statements, path + "/" + name + "/Base", file), path + "/" + name + "/Base");
      }
    check_parameters(section, study.axes);
    study.combination = section.choice<Combination>(
        "Combination", {{"product", Combination::product}, {"one at a time", Combination::one_at_a_time}});
    study.left_out       = read_left_out(section, study.axes, origin_of(statements, path + "/Leave out", file));
    study.repeats        = section.integer("Repeats", 1, 99);
    study.results        = split_names(section.text("Results"));
    study.results_origin = origin_of(statements, path + "/Results", file);
    return study;
  }
} // namespace whipple
