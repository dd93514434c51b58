// SPDX-License-Identifier: LGPL-2.1-or-later
#pragma once

#include <whipple/diagnostics/result_table.h>
#include <whipple/mesh/flat_mesh.h>
#include <whipple/problem/problem.h>
#include <whipple/projection/waiting_debris.h>
#include <whipple/registry.h>
#include <whipple/state/derived.h>
#include <whipple/state/fields.h>

#include <mpi.h>

#include <functional>
#include <map>
#include <memory>
#include <string>
#include <utility>
#include <variant>
#include <vector>

/// What a run measures: results for summary.json at certain moments, and tables that grow from step to step. Each is a
/// class that registers itself, in a file of its own (doc/extending.md).
namespace whipple
{
  /// A run as a measure sees it. All is kept by reference and is the same moment's.
  template <int dim>
  struct MeasureView
  {
    const Problem<dim>       &problem;
    std::size_t               stage; ///< number of the stage that the run is in
    const FlatMesh<dim>      &mesh;
    const State<dim>         &state;
    const Derived            &derived; ///< of this state, but for stage_begins()
    MPI_Comm                  communicator;
    const WaitingDebris<dim> *waiting; ///< debris on its way that is not in the state; null: nothing
    /// What each watch remembers, by its name in the registry; nothing of those that have not begun.
    const std::map<std::string, std::vector<double>> &memories;

    const Scene<dim>  &scene  = problem.scene;
    const FieldLayout &layout = problem.layout;
  };

  /// Where a measure puts what it has found.
  struct MeasureReport
  {
    std::map<std::string, ResultTable>                &results; ///< of the run so far, by place
    const std::function<void(const std::string &line)> warn;    ///< a warning in the log
    const std::function<void(const std::string &line)> log;     ///< one line of the log
  };

  /// Something that is worth a result. Every function is called on all ranks and may be collective; results are to be
  /// the same bits on any number of ranks.
  template <int dim>
  class Measure
  {
  public:
    virtual ~Measure() = default;

    /// A stage has taken over its state and has not made a step.
    virtual void
    stage_begins(const MeasureView<dim> &, MeasureReport &) const
    {
    }
    virtual void
    stage_ends(const MeasureView<dim> &, MeasureReport &) const
    {
    }
    /// The plates of a stage that has ended have been followed further, in a copy of the state
    /// (Stage::plates_measured).
    virtual void
    plates_have_settled(const MeasureView<dim> &, MeasureReport &) const
    {
    }
    /// The last stage has ended.
    virtual void
    run_ends(const MeasureView<dim> &, MeasureReport &) const
    {
    }

    /// What it has found in a stage, in words: a line a plate or gap, for the end of the log. What it found anew in a
    /// later stage is told there. Not collective.
    virtual std::vector<std::string>
    lines(const Scene<dim> &, std::size_t /*stage*/, const std::map<std::string, ResultTable> & /*results*/) const
    {
      return {};
    }

    /// Enter all results that a scene will have from this measure if it runs to its end; only names and types count.
    virtual void
    expect(const Problem<dim> &, std::map<std::string, ResultTable> &) const
    {
    }
  };

  /// The file of a table that grows with the steps, and the names (with units) of its columns.
  struct WatchTable
  {
    std::string              file; ///< below the output directory: "gauges/rear.csv"
    std::vector<std::string> columns;
  };

  /// Appends a row of numbers to one of a watch's tables.
  using WriteRow = std::function<void(std::size_t table, const std::vector<double> &row)>;

  /// What a measure is that looks at every step: tables beside the results. It has no state that changes: what it must
  /// know from step to step is `memory` (empty when a run begins), a part of the run state, so that it goes back with a
  /// failed step and is there after a restart. Rows of steps that are undone are dropped.
  template <int dim>
  class Watch
  {
  public:
    virtual ~Watch() = default;

    virtual std::vector<WatchTable>
    tables() const = 0;

    /// The state lies on another mesh: a stage has begun, or cells, elements or bonds are others than before. Where the
    /// material is has not changed. Collective, as the next.
    virtual void
    mesh_is_new(const MeasureView<dim> &view, std::vector<double> &memory, const WriteRow &write) const = 0;

    /// A step has been made. @param dt us
    virtual void
    step_done(const MeasureView<dim> &view, double dt, std::vector<double> &memory, const WriteRow &write) const = 0;
  };

  /// A measure, or something that watches.
  template <int dim>
  struct MeasureKind
  {
    /// Something to watch in this scene; null if there is nothing.
    using MakeWatch = std::function<std::unique_ptr<const Watch<dim>>(const Problem<dim> &problem)>;

    std::shared_ptr<const Measure<dim>> measure; ///< null: it only watches
    MakeWatch                           watch;   ///< empty: it never watches
  };

  /// All measures there are, in the order in which they measure: by place, then name.
  template <int dim>
  class MeasureRegistry : public Registry<MeasureRegistry<dim>, MeasureKind<dim>, std::pair<int, std::string>>
  {
  };

  /// Makes a measure known: one line at the end of its file,
  ///
  ///     const MeasureRegistration<2> registration(40, "plates", std::make_shared<Plates>());
  template <int dim>
  class MeasureRegistration
  {
  public:
    /// @param place in the order of all measures
    MeasureRegistration(int place, const std::string &name, std::shared_ptr<const Measure<dim>> measure)
      : registered_({place, name}, {std::move(measure), {}})
    {
    }
    MeasureRegistration(int place, const std::string &name, std::shared_ptr<const Measure<dim>> measure,
                        typename MeasureKind<dim>::MakeWatch watch)
      : registered_({place, name}, {std::move(measure), std::move(watch)})
    {
    }
    MeasureRegistration(int place, const std::string &name, typename MeasureKind<dim>::MakeWatch watch)
      : registered_({place, name}, {nullptr, std::move(watch)})
    {
    }

  private:
    typename MeasureRegistry<dim>::Registered registered_;
  };

  /// The results of a run in words, in the order in which debris meets what they tell of.
  template <int dim>
  std::vector<std::string>
  result_lines(const Scene<dim> &scene, const std::map<std::string, ResultTable> &results);

  /// All results that there will be if a run runs to its end, by place; only names and types count.
  template <int dim>
  std::map<std::string, ResultTable>
  expected_results(const Problem<dim> &problem);
} // namespace whipple
