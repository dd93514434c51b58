// SPDX-License-Identifier: LGPL-2.1-or-later
#include <whipple/error.h>
#include <whipple/problem/extra_section.h>
#include <whipple/problem/inflow_check.h>
#include <whipple/problem/problem_sections.h>
#include <whipple/problem/void_law_check.h>
#include <whipple/scene/automatic_stages.h>
#include <whipple/scene/nearest_name.h>
#include <whipple/scene/sections.h>
#include <whipple/scene/study_section.h>
#include <whipple/scene/variables.h>

#include <algorithm>
#include <cctype>
#include <fstream>

namespace whipple
{
  namespace
  {
    /// @throws InputError unless each name is made of letters, digits, blanks, '-', '_' and '.', is not "none" and
    /// stands there once.
    void
    check_names(const PrmStatement &statement, const std::vector<std::string> &names)
    {
      const auto fits = [](unsigned char c) { return std::isalnum(c) || c == ' ' || c == '-' || c == '_' || c == '.'; };
      for (const std::string &name : names)
        {
          if (name == "none" || !std::all_of(name.begin(), name.end(), fits))
            throw InputError(statement.origin, statement.name(), statement.value,
                             "'" + name + "' is no name; allowed are letters, digits, blanks, '-', '_' and '.'");
          if (std::count(names.begin(), names.end(), name) > 1)
            throw InputError(statement.origin, statement.name(), statement.value,
                             "'" + name + "' is listed twice; allowed is once");
        }
    }

    /// Names of all subsections of a section: those of every `List` that file and command line give it. (An override of
    /// List that leaves names out leaves their subsections declared, unused.)
    std::vector<std::string>
    listed_names(const std::vector<PrmStatement> &statements, const std::string &section)
    {
      std::vector<std::string> all;
      for (auto statement = statements.rbegin(); statement != statements.rend(); ++statement)
        if (statement->section == section && statement->key == "List")
          {
            const std::vector<std::string> names = split_names(statement->value);
            check_names(*statement, names);
            for (const std::string &name : names)
              if (std::find(all.begin(), all.end(), name) == all.end())
                all.push_back(name);
          }
      return all;
    }

    /// False for the subsection of a name that the final List leaves out: it has no part in the scene.
    bool
    is_listed(SceneParameters &parameters, const std::string &section)
    {
      std::vector<std::string> parents{"Effects", "Materials", "Bodies", "Stages"};
      for (const auto &[name, extra] : ExtraSectionRegistry<2>::all())
        parents.push_back(name);
      for (const std::string &parent : parents)
        if (section.starts_with(parent + '/'))
          {
            const std::vector<std::string> names = split_names(parameters.get(parent, "List"));
            return std::find(names.begin(), names.end(), section.substr(parent.size() + 1)) != names.end();
          }
      return true;
    }

    /// The section Study is for studies; a run checks that it is well formed and goes on without it.
    void
    drop_study(const std::string &file, std::vector<PrmStatement> &statements)
    {
      const auto study = read_study_section(file, statements);
      if (study && study->scene_file != file)
        throw InputError(file, "Study/Scene", study->scene_file,
                         "this file is a study of another scene: use 'whipple study', or run that scene");
      std::erase_if(statements, belongs_to_study);
    }

    void
    declare_extra(SceneParameters &parameters, const std::vector<PrmStatement> &statements)
    {
      for (const auto &[name, extra] : ExtraSectionRegistry<2>::all())
        {
          SceneSection(parameters, name)
              .declare("List", "", "names of the " + extra.listed + "; each has its subsection below");
          for (const std::string &listed : listed_names(statements, name))
            {
              SceneSection subsection(parameters, name + '/' + listed);
              extra.declare(subsection);
            }
        }
    }

    void
    declare_all(SceneParameters &parameters, const std::vector<PrmStatement> &statements)
    {
      parameters.declare("", "Title", "", "one line for logs and plots");
      sections::declare_geometry(parameters);
      sections::declare_mesh(parameters);
      sections::declare_effects(parameters);
      sections::declare_materials(parameters, listed_names(statements, "Materials"));
      sections::declare_bodies(parameters, listed_names(statements, "Bodies"));
      sections::declare_stages(parameters, listed_names(statements, "Stages"));
      sections::declare_numerics(parameters);
      sections::declare_output(parameters);
      sections::declare_exact_solution(parameters);
      declare_extra(parameters, statements);
    }

    template <int dim>
    void
    read_extra(SceneParameters &parameters, Problem<dim> &problem)
    {
      for (const auto &[name, section] : ExtraSectionRegistry<dim>::all())
        if (auto content = section.read(parameters, problem))
          problem.scene.extra[name] = std::move(content);
    }
  } // namespace

  template <int dim>
  Problem<dim>
  read_problem(const std::string &file, const std::vector<std::string> &overrides)
  {
    std::vector<PrmStatement> statements;
    for (const std::string &text : overrides)
      statements.push_back(read_override(text));
    return read_varied_problem<dim>(file, statements);
  }

  template <int dim>
  Problem<dim>
  read_varied_problem(const std::string &file, const std::vector<PrmStatement> &overrides)
  {
    std::vector<PrmStatement> statements = read_prm_statements(file);
    statements.insert(statements.end(), overrides.begin(), overrides.end());
    substitute_variables(statements);
    drop_study(file, statements);
    expand_automatic_stages(statements);

    SceneParameters parameters(file);
    declare_all(parameters, statements);
    for (const PrmStatement &statement : statements)
      parameters.assign(statement);

    Problem<dim> problem;
    Scene<dim>  &scene      = problem.scene;
    scene.file              = file;
    scene.title             = parameters.get("", "Title");
    const Vector<dim> upper = sections::read_geometry<dim>(parameters, scene);
    sections::read_mesh<dim>(parameters, upper, scene);
    sections::read_materials(parameters, problem);
    sections::place_touching_bodies<dim>(parameters, scene);
    sections::read_bodies(parameters, problem);
    sections::check_bodies<dim>(parameters, scene);
    sections::read_side_media(parameters, problem);
    scene.stages = sections::read_stages<dim>(parameters, scene);
    sections::read_effects(parameters, problem);
    scene.numerics = sections::read_numerics(parameters);
    scene.output   = sections::read_output(parameters);
    sections::check_mesh_map<dim>(parameters, scene);
    sections::read_exact_solution(parameters, problem);
    sections::check_initial_states(parameters, problem);
    sections::drive_sides(parameters, problem);
    sections::check_inflow(parameters, problem);
    sections::check_void_laws(parameters, problem);
    problem.layout = FieldLayout(scene, problem.materials);
    read_extra(parameters, problem);
    scene.effective_parameters =
        parameters.print([&](const std::string &section) { return is_listed(parameters, section); });
    return problem;
  }

  template <int dim>
  void
  write_effective_parameters(const Scene<dim> &scene, const std::string &path)
  {
    std::ofstream output(path);
    output << scene.effective_parameters << std::flush;
    if (!output)
      throw Error(path + ": cannot be written");
  }

  template Problem<2>
  read_problem(const std::string &, const std::vector<std::string> &);
  template Problem<2>
  read_varied_problem(const std::string &, const std::vector<PrmStatement> &);
  template void
  write_effective_parameters(const Scene<2> &, const std::string &);
} // namespace whipple
