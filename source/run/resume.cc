// SPDX-License-Identifier: LGPL-2.1-or-later
#include <whipple/output/first_rank.h>
#include <whipple/run/resume.h>
#include <whipple/scene/prm_statements.h>

#include <filesystem>
#include <map>
#include <sstream>

namespace whipple
{
  namespace
  {
    std::map<std::string, std::string>
    values_of(const std::string &parameters)
    {
      std::istringstream                 text(parameters);
      std::map<std::string, std::string> values;
      for (const PrmStatement &statement : read_prm_statements(text, "parameters"))
        values[statement.name()] = statement.value;
      return values;
    }

    template <int dim>
    void
    write_parameters(const Scene<dim> &scene, const std::string &directory, MPI_Comm communicator)
    {
      on_first_rank<Error>(communicator, [&] { write_effective_parameters(scene, directory + "/parameters.prm"); });
    }

    /// @throws InputError unless the scene is that of the checkpoint
    template <int dim>
    void
    require_same_scene(const Scene<dim> &scene, const std::string &directory, const checkpoint::Header<dim> &header)
    {
      for (const ChangedParameter &changed : changed_parameters(header.parameters, scene.effective_parameters))
        if (!may_change(changed.name, scene, header.books.stage))
          throw InputError(directory, changed.name, changed.now,
                           "was '" + changed.before +
                               "' when the checkpoint was written; allowed to change are Output/... and the End of "
                               "later stages");
    }
  } // namespace

  std::vector<ChangedParameter>
  changed_parameters(const std::string &before, const std::string &now)
  {
    const auto                    old_values = values_of(before), new_values = values_of(now);
    std::vector<ChangedParameter> changed;
    for (const auto &[name, value] : new_values)
      {
        const auto old = old_values.find(name);
        if (old == old_values.end() || old->second != value)
          changed.push_back({name, old == old_values.end() ? "" : old->second, value});
      }
    for (const auto &[name, value] : old_values)
      if (!new_values.count(name))
        changed.push_back({name, value, ""});
    return changed;
  }

  template <int dim>
  bool
  may_change(const std::string &name, const Scene<dim> &scene, std::size_t stage)
  {
    if (name.starts_with("Output/"))
      return true;
    for (std::size_t later = stage + 1; later < scene.stages.size(); ++later)
      if (name == "Stages/" + scene.stages[later].name + "/End")
        return true;
    return false;
  }

  template <int dim>
  std::unique_ptr<Simulation<dim>>
  start(const Problem<dim> &problem, RunPlace place, EarlierRun earlier, MPI_Comm communicator)
  {
    place.lock = std::make_shared<DirectoryLock>(prepare_output_directory(place.directory, earlier, communicator));
    write_parameters(problem.scene, place.directory, communicator);
    return std::make_unique<Simulation<dim>>(problem, place, communicator);
  }

  template <int dim>
  std::unique_ptr<Simulation<dim>>
  go_on(const Problem<dim> &problem, RunPlace place, MPI_Comm communicator)
  {
    on_first_rank<InputError>(communicator, [&] { place.lock = std::make_shared<DirectoryLock>(place.directory); });
    const auto found = CheckpointStore<dim>::newest(place.directory, communicator);
    if (!found.header && !found.refused.empty())
      throw InputError(place.directory + ": no checkpoint to go on from: " + found.refused.front());
    if (!found.header)
      {
        // an interrupted run has one; before its first a run leaves no summary
        if (std::filesystem::exists(place.directory + "/summary.json"))
          throw InputError(place.directory + ": has no checkpoint, and its run is over");
        write_parameters(problem.scene, place.directory, communicator);
        auto simulation = std::make_unique<Simulation<dim>>(problem, place, communicator);
        simulation->log().info("there was no checkpoint yet: the run begins anew");
        return simulation;
      }
    require_same_scene(problem.scene, place.directory, *found.header);
    write_parameters(problem.scene, place.directory, communicator);
    auto simulation =
        std::make_unique<Simulation<dim>>(problem, place, found.directory, found.header->books, communicator);
    for (const std::string &reason : found.refused)
      simulation->log().info("an older checkpoint is used: " + reason);
    return simulation;
  }

  template bool
  may_change(const std::string &, const Scene<2> &, std::size_t);
  template std::unique_ptr<Simulation<2>>
  start(const Problem<2> &, RunPlace, EarlierRun, MPI_Comm);
  template std::unique_ptr<Simulation<2>>
  go_on(const Problem<2> &, RunPlace, MPI_Comm);
} // namespace whipple
