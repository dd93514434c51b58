// SPDX-License-Identifier: LGPL-2.1-or-later
#include <whipple/error.h>
#include <whipple/problem/problem.h>
#include <whipple/scene/variables.h>
#include <whipple/study/study_plan.h>

#include <algorithm>
#include <cctype>
#include <set>

namespace whipple
{
  namespace
  {
    using Choice = std::vector<std::size_t>;

    /// More are a mistake in the axes, not a study.
    constexpr std::size_t most_points = 10000;

    std::string
    file_name_of(const std::string &label)
    {
      std::string name;
      for (const char c : label)
        if (std::isalnum(static_cast<unsigned char>(c)) || std::string_view(".-+%").find(c) != std::string_view::npos)
          name += c;
        else if (c != ' ')
          name += '_';
      return name;
    }

    std::vector<Choice>
    product(const StudySection &section)
    {
      std::vector<Choice> all{{}};
      for (const StudyAxis &axis : section.axes)
        {
          if (all.size() * axis.values.size() > most_points)
            throw InputError(axis.origin, "Study/Axes", axis.name,
                             "more than " + std::to_string(most_points) + " points; allowed are fewer");
          std::vector<Choice> longer;
          for (const Choice &choice : all)
            for (std::size_t v = 0; v < axis.values.size(); ++v)
              {
                longer.push_back(choice);
                longer.back().push_back(v);
              }
          all = std::move(longer);
        }
      const auto left_out = [&](const Choice &choice) {
        return std::any_of(section.left_out.begin(), section.left_out.end(), [&](const StudyChoice &part) {
          return std::all_of(part.begin(), part.end(),
                             [&](const auto &pair) { return choice[pair.first] == pair.second; });
        });
      };
      std::erase_if(all, left_out);
      return all;
    }

    std::vector<Choice>
    one_at_a_time(const StudySection &section)
    {
      Choice base;
      for (const StudyAxis &axis : section.axes)
        base.push_back(axis.base);
      std::vector<Choice> all{base};
      for (std::size_t a = 0; a < section.axes.size(); ++a)
        for (std::size_t v = 0; v < section.axes[a].values.size(); ++v)
          if (v != base[a])
            {
              all.push_back(base);
              all.back()[a] = v;
            }
      return all;
    }

    /// Overrides of the command line, those of the study itself told apart.
    std::vector<PrmStatement>
    command_line_overrides(const StudyOptions &options, bool of_study)
    {
      std::vector<PrmStatement> statements;
      for (const std::string &text : options.overrides)
        statements.push_back(read_override(text));
      std::erase_if(statements, [&](const PrmStatement &s) { return belongs_to_study(s) != of_study; });
      return statements;
    }

    void
    check_not_an_axis(const StudySection &section, const std::vector<PrmStatement> &overrides)
    {
      for (const PrmStatement &statement : overrides)
        for (const StudyAxis &axis : section.axes)
          if (std::find(axis.parameters.begin(), axis.parameters.end(), statement.name()) != axis.parameters.end())
            throw InputError(statement.origin, statement.name(), statement.value,
                             "the axis '" + axis.name + "' of the study moves it; allowed are other parameters");
    }

    void
    check_labels(const StudySection &section)
    {
      for (const StudyAxis &axis : section.axes)
        {
          std::set<std::string> names;
          for (const StudyValue &value : axis.values)
            if (!names.insert(file_name_of(value.label)).second)
              throw InputError(axis.origin, "Study/" + axis.name + "/Labels", value.label,
                               "gives the same directory as another label; allowed are labels that differ in letters "
                               "or digits");
        }
    }

    /// What a combination of values sets in a scene, and its number of ranks.
    StudyPoint
    make_point(const StudySection &section, const std::vector<PrmStatement> &overrides, int ranks, const Choice &choice)
    {
      StudyPoint point;
      point.choice    = choice;
      point.label     = point_label(section, choice);
      point.overrides = section.overrides;
      point.ranks     = ranks;
      point.overrides.insert(point.overrides.end(), overrides.begin(), overrides.end());
      for (std::size_t a = 0; a < section.axes.size(); ++a)
        {
          const StudyAxis &axis = section.axes[a];
          for (std::size_t p = 0; p < axis.parameters.size(); ++p)
            {
              const std::string &text = axis.values[choice[a]].parts[p];
              if (axis.parameters[p] == ranks_parameter)
                {
                  point.ranks = std::stoi(text);
                  continue;
                }
              point.overrides.push_back(read_override(axis.parameters[p] + " = " + text));
              point.overrides.back().origin = axis.origin;
            }
        }
      return point;
    }

    /// Check a point as a scene, and learn from that what it will report.
    void
    add_point(StudyPlan &plan, StudyPoint point)
    {
      const Problem<2> problem   = read_varied_problem<2>(plan.section.scene_file, point.overrides);
      const Scene<2>  &scene     = problem.scene;
      point.cell                 = scene.lattice.spacing;
      point.effective_parameters = scene.effective_parameters;
      plan.title                 = scene.title;
      plan.has_exact_solution    = plan.has_exact_solution || problem.exact;
      for (auto &[place, table] : expected_results<2>(problem))
        plan.results[place].merge(table);
      plan.points.push_back(std::move(point));
    }

    void
    check_results(const StudyPlan &plan)
    {
      for (const std::string &name : plan.section.results)
        {
          const std::size_t slash = name.find('/');
          const auto        place = plan.results.find(name.substr(0, slash));
          if (slash != std::string::npos && place != plan.results.end() &&
              place->second.contains(name.substr(slash + 1)))
            continue;
          std::string known;
          for (const auto &[where, table] : plan.results)
            for (const auto &[quantity, value] : table)
              known += (known.empty() ? "" : ", ") + where + '/' + quantity;
          throw InputError(plan.section.results_origin, "Study/Results", name,
                           "no such result; " + (known.empty() ? "the scene has none" : "allowed are " + known));
        }
    }
  } // namespace

  StudySection
  read_study(const StudyOptions &options)
  {
    std::vector<PrmStatement>       statements = read_prm_statements(options.file);
    const std::vector<PrmStatement> more       = command_line_overrides(options, true);
    statements.insert(statements.end(), more.begin(), more.end());
    substitute_variables(statements);
    if (auto section = read_study_section(options.file, statements))
      {
        const auto foreign = std::find_if_not(statements.begin(), statements.end(), belongs_to_study);
        if (section->scene_file != options.file && foreign != statements.end())
          throw InputError(foreign->origin, foreign->name(), foreign->value,
                           "the study names its scene; allowed beside that is only the section Study");
        return *section;
      }
    if (options.tolerance.empty())
      throw InputError(options.file + ": has no section Study; add one (doc/studies.md) or give --tolerance");
    StudySection section;
    section.scene_file = options.file;
    return section;
  }

  std::string
  point_label(const StudySection &section, const std::vector<std::size_t> &choice)
  {
    std::string label;
    for (std::size_t a = 0; a < choice.size(); ++a)
      {
        const StudyAxis &axis    = section.axes[a];
        const bool       at_base = section.combination == Combination::one_at_a_time && choice[a] == axis.base;
        if (axis.is_cell_axis() || !at_base)
          label +=
              (label.empty() ? "" : ",") + file_name_of(axis.name) + '=' + file_name_of(axis.values[choice[a]].label);
      }
    return label.empty() ? "base" : label;
  }

  std::string
  point_name(const StudySection &section, const std::vector<std::size_t> &choice)
  {
    const std::string method = method_name(section, choice);
    const auto        cell   = section.cell_axis();
    if (!cell)
      return method;
    return section.axes[*cell].values[choice[*cell]].label + (method == "base" ? "" : ", " + method);
  }

  std::string
  method_name(const StudySection &section, const std::vector<std::size_t> &choice)
  {
    const bool  one_at_a_time = section.combination == Combination::one_at_a_time;
    std::string name;
    for (std::size_t a = 0; a < choice.size(); ++a)
      {
        const StudyAxis &axis = section.axes[a];
        if (axis.is_cell_axis() || (one_at_a_time && choice[a] == axis.base))
          continue;
        name += (name.empty() ? "" : ", ") + (one_at_a_time ? axis.name + ": " : "") + axis.values[choice[a]].label;
      }
    return name.empty() ? "base" : name;
  }

  StudyPlan
  plan_study(const StudyOptions &options, const StudySection &section)
  {
    const std::vector<PrmStatement> overrides = command_line_overrides(options, false);
    check_labels(section);
    check_not_an_axis(section, overrides);
    StudyPlan plan;
    plan.file    = options.file;
    plan.section = section;
    for (const Choice &choice : section.combination == Combination::product ? product(section) : one_at_a_time(section))
      add_point(plan, make_point(section, overrides, options.ranks, choice));
    if (plan.points.empty())
      throw InputError(options.file + ": Study/Leave out leaves no point; allowed is to leave out less");
    std::stable_sort(plan.points.begin(), plan.points.end(),
                     [](const StudyPoint &a, const StudyPoint &b) { return a.cell > b.cell; });
    check_results(plan);
    return plan;
  }
} // namespace whipple
