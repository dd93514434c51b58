// SPDX-License-Identifier: LGPL-2.1-or-later
#include <whipple/output/duration.h>
#include <whipple/scene/units.h>
#include <whipple/study/quantity_name.h>
#include <whipple/study/tolerance_run.h>

#include <algorithm>
#include <chrono>
#include <cmath>
#include <limits>

namespace whipple
{
  namespace
  {
    constexpr std::size_t levels_to_learn_from = 3;

    using Clock = std::chrono::steady_clock;

    struct Method
    {
      std::string             label;
      std::vector<StudyPoint> points; ///< coarse to fine
    };

    std::vector<Method>
    methods_of(const StudyPlan &plan)
    {
      std::vector<Method> methods;
      for (const StudyPoint &point : plan.points)
        {
          const std::string label = method_name(plan.section, point.choice);
          auto found = std::find_if(methods.begin(), methods.end(), [&](const Method &m) { return m.label == label; });
          if (found == methods.end())
            found = methods.insert(methods.end(), {label, {}});
          found->points.push_back(point);
        }
      return methods;
    }

    /// The setting of least time among those that satisfy a condition.
    template <typename Condition>
    std::optional<std::size_t>
    cheapest(const std::vector<MethodForecast> &methods, CellForecast &chosen, const Condition &condition)
    {
      std::optional<std::size_t> method;
      for (std::size_t m = 0; m < methods.size(); ++m)
        for (const CellForecast &row : methods[m].rows)
          if (condition(row) && (!method || row.seconds < chosen.seconds))
            {
              method = m;
              chosen = row;
            }
      return method;
    }

    std::string
    setting(const ToleranceVerdict &verdict, std::size_t method, const CellForecast &row)
    {
      const std::string &label = verdict.methods[method].label;
      return "cells of " + units::format(row.cell, units::length) + (label == "base" ? "" : " with " + label);
    }

    std::string
    expectation(const Tolerance &tolerance, const CellForecast &row)
    {
      return "an error of " + show_error(tolerance, row.error) + " in " + duration(row.seconds);
    }

    /// What the best setting within some seconds would be.
    std::string
    best_within(const ToleranceVerdict &verdict, double seconds)
    {
      const CellForecast *best   = nullptr;
      std::size_t         method = 0;
      for (std::size_t m = 0; m < verdict.methods.size(); ++m)
        for (const CellForecast &row : verdict.methods[m].rows)
          if ((row.computed || row.seconds <= seconds) && (!best || row.error < best->error))
            {
              best   = &row;
              method = m;
            }
      if (!best)
        return "It buys nothing.";
      return "It buys " + setting(verdict, method, *best) + (best->computed ? ", which have run: " : ": ") +
             expectation(verdict.tolerance, *best) + '.';
    }

    /// The cells that a method would need, by its law of error.
    std::string
    what_would_reach(const MethodForecast &method, const Tolerance &tolerance)
    {
      const double cell = std::pow(tolerance.amount / method.error.factor, 1. / method.error.exponent);
      return "By its law of error it would take cells of " + digits(cell, 2) + " cm, about " +
             duration(method.cost.seconds(cell)) + ".";
    }

    std::string
    nothing_reaches(const ToleranceVerdict &verdict)
    {
      std::string text = "No cell size to choose from reaches the tolerance.";
      for (const MethodForecast &method : verdict.methods)
        if (!method.excluded.empty())
          text += "\n" + method.label + ": " + method.excluded;
        else if (!method.rows.empty())
          text += "\n" + method.label + ": the finest, " + units::format(method.rows.back().cell, units::length) +
                  ", promises " + expectation(verdict.tolerance, method.rows.back()) + ". " +
                  what_would_reach(method, verdict.tolerance);
      return text;
    }

    std::string
    off_by(double truth, double forecast)
    {
      const double ratio = truth / forecast;
      return digits(ratio, 2) + " times the forecast";
    }

    /// Judge the final run with those before it, and the forecasts with it.
    void
    judge(ToleranceVerdict &verdict, const std::vector<PointOutcome> &levels)
    {
      const PointOutcome &last      = levels.back();
      const Tolerance    &tolerance = verdict.tolerance;
      const ErrorNow      now = last.record.completed() ? error_now(levels, tolerance) : ErrorNow{last.record.reason};
      if (!now.reason.empty())
        {
          verdict.conclusion += "\nThe run failed: " + now.reason;
          return;
        }
      verdict.final_error   = now.error;
      verdict.reached       = now.error <= tolerance.amount;
      verdict.final_seconds = last.record.cost.wall_s;
      const double value    = *value_of(last.record, tolerance.quantity);
      if (!tolerance.quantity.exact)
        verdict.conclusion += "\n" + tolerance.quantity.readable() + ": " + digits(value, 4);
      verdict.conclusion +=
          "\nError: " + show_error(tolerance, now.error) + (tolerance.quantity.exact ? "" : " (" + now.verdict + ")") +
          ", forecast " + show_error(tolerance, verdict.chosen.error) + ": " + off_by(now.error, verdict.chosen.error) +
          "\nTime: " + duration(verdict.final_seconds) + ", forecast " + duration(verdict.chosen.seconds) + ": " +
          off_by(verdict.final_seconds, verdict.chosen.seconds) + "\nThe tolerance of " +
          show_error(tolerance, tolerance.amount) +
          (verdict.reached ? " is reached." : " is missed: ask again, this run now counts.");
    }

    void
    choose(ToleranceVerdict &verdict, double left)
    {
      const Tolerance &tolerance = verdict.tolerance;
      verdict.method             = cheapest(verdict.methods, verdict.chosen,
                                            [&](const CellForecast &row) { return row.error <= tolerance.amount; });
      if (!verdict.method)
        {
          verdict.conclusion = nothing_reaches(verdict);
          return;
        }
      verdict.conclusion = "Cheapest setting that reaches " + show_error(tolerance, tolerance.amount) + ": " +
                           setting(verdict, *verdict.method, verdict.chosen) + ", " +
                           expectation(tolerance, verdict.chosen) + '.';
      if (verdict.chosen.computed)
        {
          verdict.conclusion += "\nIt has run already.";
          verdict.reached = true;
          verdict.method.reset();
        }
      else if (verdict.chosen.seconds > left)
        {
          verdict.conclusion += "\nIt does not fit what is left of the budget, " + duration(std::max(left, 0.)) + ". " +
                                best_within(verdict, left);
          verdict.method.reset();
        }
    }
  } // namespace

  ToleranceOutcome
  run_to_tolerance(const StudyPlan &plan, const Tolerance &tolerance, std::optional<double> budget_s,
                   StudyRunner &runner, std::ostream &output)
  {
    const auto       start = Clock::now();
    ToleranceOutcome result;
    result.verdict.tolerance = tolerance;
    result.verdict.budget_s  = budget_s;

    const std::vector<Method> methods = methods_of(plan);
    std::vector<StudyPoint>   coarse;
    for (const StudyPoint &point : plan.points)
      for (const Method &method : methods)
        for (std::size_t i = 0; i < std::min(levels_to_learn_from, method.points.size()); ++i)
          if (method.points[i] == point)
            coarse.push_back(point);
    result.outcomes = runner.run(plan, coarse);

    std::vector<std::vector<PointOutcome>> levels;
    for (const Method &method : methods)
      {
        std::vector<PointOutcome> &own = levels.emplace_back();
        for (const PointOutcome &outcome : result.outcomes)
          if (std::find(method.points.begin(), method.points.end(), outcome.point) != method.points.end())
            own.push_back(outcome);
        result.verdict.methods.push_back(forecast_method(plan, own, tolerance, method.label));
        output << "\n" << method.label << " (" << result.verdict.methods.back().verdict << ")\n";
        output << (result.verdict.methods.back().excluded.empty()
                       ? forecast_table(result.verdict.methods.back(), tolerance)
                       : result.verdict.methods.back().excluded + "\n");
      }
    const double spent = std::chrono::duration<double>(Clock::now() - start).count();
    choose(result.verdict, budget_s ? *budget_s - spent : std::numeric_limits<double>::infinity());
    output << '\n' << result.verdict.conclusion << "\n\n" << std::flush;
    if (!result.verdict.method)
      return result;

    const std::size_t said  = result.verdict.conclusion.size();
    auto             &chain = levels[*result.verdict.method];
    result.outcomes.push_back(runner.run(plan, {plan.points[result.verdict.chosen.point]}).front());
    chain.push_back(result.outcomes.back());
    judge(result.verdict, chain);
    output << result.verdict.conclusion.substr(said + 1) << '\n';
    return result;
  }
} // namespace whipple
