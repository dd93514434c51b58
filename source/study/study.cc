// SPDX-License-Identifier: LGPL-2.1-or-later
#include <whipple/error.h>
#include <whipple/study/cell_ladder.h>
#include <whipple/study/report.h>
#include <whipple/study/study.h>
#include <whipple/study/study_directory.h>

#include <algorithm>

namespace whipple
{
  namespace
  {
    report::StudyReport
    all_points(const StudyOptions &options, const StudyPlan &plan, std::ostream &output)
    {
      const DirectoryLock lock = prepare_study_directory(options.output_directory, options.file);
      StudyRunner         runner(options, output);
      report::StudyReport result{options, plan, {}, {}, {}};
      result.outcomes = runner.run(plan, plan.points);
      return result;
    }

    /// The cell axis of a ladder begins at the scene's own cells, and so has taken up what --set says of them.
    StudyOptions
    without_cells(StudyOptions options, const StudySection &ladder)
    {
      const std::vector<std::string> &taken = ladder.axes[*ladder.cell_axis()].parameters;
      std::erase_if(options.overrides, [&](const std::string &text) {
        return std::find(taken.begin(), taken.end(), read_override(text).name()) != taken.end();
      });
      return options;
    }

    report::StudyReport
    to_tolerance(const StudyOptions &options, const StudySection &section, const Tolerance &tolerance,
                 std::ostream &output)
    {
      const std::optional<double> budget =
          options.budget.empty() ? std::nullopt : std::optional<double>(read_budget(options.budget));
      const StudySection ladder = with_cell_ladder(options, section);
      const StudyPlan    plan   = plan_study(section.cell_axis() ? options : without_cells(options, ladder), ladder);
      if (options.validate_only)
        return {options, plan, {}, {}, {}};
      const DirectoryLock lock = prepare_study_directory(options.output_directory, options.file);
      StudyRunner         runner(options, output);
      ToleranceOutcome    outcome = run_to_tolerance(plan, tolerance, budget, runner, output);
      report::StudyReport result{options, plan, std::move(outcome.outcomes), {}, std::move(outcome.verdict)};
      return result;
    }

    /// A study that has not done what it was asked for ends as its runs did: stopped by physics or numerics, or
    /// otherwise.
    void
    require_success(const report::StudyReport &result)
    {
      const std::string page          = result.options.output_directory + "/study.md";
      const auto        is_incomplete = [](const PointOutcome &outcome) { return !outcome.record.completed(); };
      const auto        number        = std::count_if(result.outcomes.begin(), result.outcomes.end(), is_incomplete);
      if (number > 0)
        {
          const PointOutcome &first   = *std::find_if(result.outcomes.begin(), result.outcomes.end(), is_incomplete);
          const std::string   message = std::to_string(number) + " of " + std::to_string(result.outcomes.size()) +
                                      " points of the study did not complete, " + first.point.label + ": " +
                                      first.record.reason + " (" + page + ")";
          const bool all_stopped = std::all_of(result.outcomes.begin(), result.outcomes.end(), [](const auto &outcome) {
            return outcome.record.completed() || outcome.record.status == "stopped";
          });
          if (all_stopped)
            throw StateError(message);
          throw Error(message);
        }
      if (result.tolerance && !result.tolerance->reached)
        throw Error("the tolerance of " + show_error(result.tolerance->tolerance, result.tolerance->tolerance.amount) +
                    " is not reached (" + page + ")");
    }

    void
    list_points(const StudyPlan &plan, std::ostream &output)
    {
      for (const StudyPoint &point : plan.points)
        output << point.label << '\n';
      output << plan.points.size() << " points, all of them valid\n";
    }
  } // namespace

  void
  run_study(const StudyOptions &options, std::ostream &output)
  {
    const StudySection section = read_study(options);
    const StudyPlan    plan    = plan_study(options, section);
    if (options.tolerance.empty() && !options.budget.empty())
      throw InputError("command line", "--budget", options.budget, "needs a --tolerance to spend it on");
    report::StudyReport result;
    if (options.tolerance.empty())
      {
        if (options.validate_only)
          return list_points(plan, output);
        result = all_points(options, plan, output);
      }
    else
      {
        result = to_tolerance(options, section, read_tolerance(options.tolerance, plan), output);
        if (options.validate_only)
          return list_points(result.plan, output);
      }
    std::stable_sort(result.outcomes.begin(), result.outcomes.end(),
                     [](const PointOutcome &a, const PointOutcome &b) { return a.point.cell > b.point.cell; });
    result.analysis = analyse(result.plan, result.outcomes);
    report::write(result);
    output << "written: " << options.output_directory << "/study.md, study.csv, study.json\n" << std::flush;
    require_success(result);
  }
} // namespace whipple
