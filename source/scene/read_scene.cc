// SPDX-License-Identifier: LGPL-2.1-or-later
#include <whipple/error.h>
#include <whipple/scene/nearest_name.h>
#include <whipple/scene/sections.h>

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
    }
  } // namespace

  template <int dim>
  Scene<dim>
  read_scene(const std::string &file, const std::vector<std::string> &overrides)
  {
    std::vector<PrmStatement> statements = read_prm_statements(file);
    for (const std::string &text : overrides)
      statements.push_back(read_override(text));

    SceneParameters parameters(file);
    declare_all(parameters, statements);
    for (const PrmStatement &statement : statements)
      parameters.assign(statement);

    Scene<dim> scene;
    scene.file              = file;
    scene.title             = parameters.get("", "Title");
    const Vector<dim> upper = sections::read_geometry<dim>(parameters, scene);
    sections::read_mesh<dim>(parameters, upper, scene);
    scene.effects   = sections::read_effects(parameters);
    scene.materials = sections::read_materials(parameters, scene.effects);
    scene.bodies    = sections::read_bodies<dim>(parameters, scene);
    sections::check_bodies<dim>(parameters, scene);
    scene.stages               = sections::read_stages<dim>(parameters, scene);
    scene.numerics             = sections::read_numerics(parameters);
    scene.output               = sections::read_output(parameters);
    scene.exact_solution       = sections::read_exact_solution(parameters);
    scene.effective_parameters = parameters.print();
    return scene;
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

  template Scene<2>
  read_scene(const std::string &, const std::vector<std::string> &);
  template void
  write_effective_parameters(const Scene<2> &, const std::string &);
} // namespace whipple
