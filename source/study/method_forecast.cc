// SPDX-License-Identifier: LGPL-2.1-or-later
#include <whipple/output/duration.h>
#include <whipple/scene/units.h>
#include <whipple/study/quantity_name.h>
#include <whipple/study/tolerance_run.h>

#include <algorithm>
#include <cmath>

namespace whipple
{
  namespace
  {
    /// What an absolute error is divided by to compare it with the tolerance; none if the value is 0 or not known.
    std::optional<double>
    scale_of(const std::vector<PointOutcome> &levels, const Tolerance &tolerance, const convergence::Estimate &estimate)
    {
      if (!tolerance.relative)
        return 1.;
      std::optional<double> scale = std::abs(estimate.limit());
      if (tolerance.quantity.exact)
        {
          Quantity size = tolerance.quantity;
          size.name     = "scale";
          scale         = value_of(levels.back().record, size);
        }
      return scale && *scale > 0 ? scale : std::nullopt;
    }

    std::string
    order_text(const convergence::Estimate &estimate)
    {
      return convergence::name(estimate.verdict) +
             (estimate.order ? ", order " + digits(*estimate.order, 3) : std::string());
    }
  } // namespace

  ErrorNow
  error_now(const std::vector<PointOutcome> &levels, const Tolerance &tolerance)
  {
    std::vector<convergence::Level> values;
    for (const PointOutcome &outcome : levels)
      if (const auto value = value_of(outcome.record, tolerance.quantity))
        values.push_back({outcome.point.cell, *value});
    constexpr std::size_t least_levels = 2;
    if (values.size() < std::max(levels.size(), least_levels))
      return {.reason = "two runs or more must have a value of " + tolerance.quantity.readable()};
    if (tolerance.quantity.exact &&
        std::any_of(values.begin(), values.end(), [](const auto &l) { return !(l.value > 0); }))
      return {.reason = tolerance.quantity.readable() + " is 0 in a run: nothing shrinks"};
    const convergence::Estimate estimate = convergence::estimate(values);
    const auto                  scale    = scale_of(levels, tolerance, estimate);
    if (!scale)
      return {.reason = tolerance.quantity.readable() + " has nothing to be relative to; give the tolerance an amount"};
    ErrorNow now;
    now.scale = *scale;
    if (tolerance.quantity.exact)
      {
        now.law     = convergence::fit_power_law(values);
        now.error   = values.back().value / *scale;
        now.verdict = "order " + digits(now.law.exponent, 3);
      }
    else
      {
        // what moves on without a clear order is not trusted to move on faster than with order 1
        const bool   clear = estimate.verdict == convergence::Verdict::monotone;
        const double order =
            clear ? std::clamp(*estimate.order, convergence::least_order, convergence::formal_order) : 1.;
        now.limit             = estimate.limit();
        now.limit_uncertainty = estimate.limit_uncertainty();
        now.error             = *estimate.error_bar / *scale;
        now.law               = {*estimate.error_bar / std::pow(values.back().cell, order), order};
        now.verdict           = order_text(estimate);
      }
    now.law.factor /= *scale;
    return now;
  }

  MethodForecast
  forecast_method(const StudyPlan &plan, const std::vector<PointOutcome> &coarse, const Tolerance &tolerance,
                  const std::string &label)
  {
    MethodForecast method;
    method.label = label;
    std::vector<CostSample> costs;
    for (const PointOutcome &outcome : coarse)
      {
        const PointRecord &record = outcome.record;
        if (!record.completed())
          {
            method.excluded =
                point_name(plan.section, outcome.point.choice) + " " + record.status + ": " + record.reason;
            return method;
          }
        costs.push_back({outcome.point.cell, record.cost.active_cell_steps, record.cost.wall_s});
      }
    const ErrorNow now = error_now(coarse, tolerance);
    method.excluded    = now.reason;
    method.verdict     = now.verdict;
    method.error       = now.law;
    if (!method.excluded.empty())
      return method;
    if (!(now.law.exponent > 0))
      {
        method.excluded = "the errors of its coarse runs do not shrink (" + now.verdict + ")";
        return method;
      }
    method.cost = fit_cost(costs);
    for (std::size_t i = 0; i < plan.points.size(); ++i)
      {
        const StudyPoint &point = plan.points[i];
        if (method_name(plan.section, point.choice) != label)
          continue;
        CellForecast row{i, point.cell, now.law(point.cell), method.cost.seconds(point.cell), false};
        for (const PointOutcome &outcome : coarse)
          if (outcome.point == point)
            {
              row.computed = true;
              row.seconds  = outcome.record.cost.wall_s;
              row.error =
                  (std::abs(*value_of(outcome.record, tolerance.quantity) - now.limit) + now.limit_uncertainty) /
                  now.scale;
            }
        method.rows.push_back(row);
      }
    return method;
  }

  std::string
  show_error(const Tolerance &tolerance, double error)
  {
    constexpr int significant = 2;
    if (tolerance.relative)
      return digits(100. * error, significant) + " %";
    return digits(error, significant) + ' ' + tolerance.quantity.unit();
  }

  std::string
  forecast_table(const MethodForecast &method, const Tolerance &tolerance)
  {
    std::string table = "| cell size | expected error | expected time | |\n|---|---|---|---|\n";
    bool        below = false;
    for (const CellForecast &row : method.rows)
      {
        if (below && !row.computed)
          break;
        below = below || row.error <= tolerance.amount;
        table += "| " + units::format(row.cell, units::length) + " | " + show_error(tolerance, row.error) + " | " +
                 duration(row.seconds) + " | " + (row.computed ? "has run" : "") + " |\n";
      }
    return table;
  }
} // namespace whipple
