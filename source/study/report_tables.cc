// SPDX-License-Identifier: LGPL-2.1-or-later
#include <whipple/output/duration.h>
#include <whipple/study/markdown_table.h>
#include <whipple/study/quantity_name.h>
#include <whipple/study/report_tables.h>

#include <algorithm>
#include <cmath>
#include <set>

namespace whipple::report
{
  namespace
  {
    constexpr int value_digits = 5, error_digits = 2, order_digits = 3;

    std::string
    order_text(const std::optional<double> &order)
    {
      constexpr double sensible = 10; // what lies outside is an accident of two nearly equal numbers
      return order && std::abs(*order) < sensible ? digits(*order, order_digits) : "";
    }

    std::string
    error_text(const PointError &error, const Quantity &quantity)
    {
      const auto show = [&](double value) {
        return error.relative ? digits(100. * value, error_digits) + " %" : digits(value, error_digits);
      };
      return show(error.error) + (quantity.exact ? "" : " + " + show(error.uncertainty));
    }

    struct Priced
    {
      const PointOutcome *outcome;
      PointError          error;
    };

    /// A method to choose: in a study of one axis at a time the choices are of physics, and only the mesh is to choose.
    bool
    is_to_choose(const StudyReport &report, const PointOutcome &outcome)
    {
      const StudySection &section = report.plan.section;
      return outcome.record.completed() &&
             (section.combination == Combination::product || method_name(section, outcome.point.choice) == "base");
    }

    /// Cheapest first, each better than all cheaper ones.
    std::vector<Priced>
    undominated(const StudyReport &report, const Quantity &quantity)
    {
      std::vector<Priced> all, best;
      for (const PointOutcome &outcome : report.outcomes)
        if (const auto error = point_error(report.analysis, outcome.record, quantity);
            error && is_to_choose(report, outcome))
          all.push_back({&outcome, *error});
      std::stable_sort(all.begin(), all.end(), [](const Priced &a, const Priced &b) {
        return a.outcome->record.cost.wall_s < b.outcome->record.cost.wall_s;
      });
      for (const Priced &priced : all)
        if (best.empty() ||
            priced.error.error + priced.error.uncertainty < best.back().error.error + best.back().error.uncertainty)
          best.push_back(priced);
      return best;
    }

    /// Where the references come from.
    std::string
    references_table(const StudyReport &report, const std::vector<Quantity> &quantities)
    {
      std::string rows;
      for (const Quantity &quantity : quantities)
        if (const Reference *reference = quantity.exact ? nullptr : report.analysis.reference(quantity))
          rows += row({quantity.readable(), digits(reference->value, value_digits),
                       "± " + digits(reference->uncertainty, error_digits), reference->series});
      return rows.empty()
                 ? rows
                 : "\nErrors of results are the distance from this reference + what it may be wrong by itself:\n\n" +
                       head({"quantity", "reference", "", "from"}) + rows;
    }

    std::string
    results_of(const StudyReport &report, const Series &series)
    {
      std::set<double, std::greater<>> cells;
      for (const Trend &trend : series.results)
        for (const convergence::Level &level : trend.levels)
          cells.insert(level.cell);
      std::vector<std::string> columns{"result"};
      for (const double cell : cells)
        columns.push_back(cell_text(cell));
      columns.insert(columns.end(), {"order", "limit", "error bar", "convergence"});
      std::string rows;
      for (const Trend &trend : series.results)
        {
          if (trend.levels.empty() || !in_tables(report, trend.quantity))
            continue;
          std::vector<std::string> line{trend.quantity.readable()};
          for (const double cell : cells)
            {
              const auto level = std::find_if(trend.levels.begin(), trend.levels.end(),
                                              [&](const convergence::Level &l) { return l.cell == cell; });
              line.push_back(level == trend.levels.end() ? "" : digits(level->value, value_digits));
            }
          const convergence::Estimate &e = trend.estimate;
          line.push_back(e.verdict == convergence::Verdict::monotone ? order_text(e.order) : "");
          line.push_back(e.extrapolated ? digits(*e.extrapolated, value_digits) : "");
          line.push_back(e.error_bar ? "± " + digits(*e.error_bar, error_digits) : "");
          line.push_back(convergence::name(e.verdict));
          rows += row(line);
        }
      return rows.empty() ? rows : "\n### " + series.label + "\n\n" + head(columns) + rows;
    }

    std::string
    values_of(const Verdicts &verdict)
    {
      std::string text;
      for (const auto &[cell, yes] : verdict.levels)
        text += (text.empty() ? "" : ", ") + cell_text(cell) + ": " + (yes ? "yes" : "no");
      return text;
    }

    /// Where a verdict flips along its series.
    std::string
    flips(const Verdicts &verdict)
    {
      std::string text;
      for (std::size_t l = 1; l < verdict.levels.size(); ++l)
        if (verdict.levels[l].second != verdict.levels[l - 1].second)
          text += (text.empty() ? "flips between " : ", and ") + cell_text(verdict.levels[l - 1].first) + " and " +
                  cell_text(verdict.levels[l].first);
      return text.empty() ? "the same on all cells" : "**" + text + "**";
    }

    /// The same verdict of another series on cells of some size.
    std::optional<bool>
    value_on(const Series &series, const Verdicts &verdict, double cell)
    {
      for (const Verdicts &other : series.verdicts)
        if (other.place == verdict.place && other.name == verdict.name)
          for (const auto &[size, yes] : other.levels)
            if (size == cell)
              return yes;
      return std::nullopt;
    }
  } // namespace

  std::string
  what_to_use(const StudyReport &report)
  {
    const std::vector<Quantity> quantities = headlines(report);
    std::string                 rows;
    for (const Quantity &quantity : quantities)
      {
        std::string name = quantity.readable();
        for (const Priced &priced : undominated(report, quantity))
          {
            rows += row({name, error_text(priced.error, quantity),
                         point_name(report.plan.section, priced.outcome->point.choice),
                         duration(priced.outcome->record.cost.wall_s)});
            name.clear(); // once is enough
          }
      }
    return rows.empty()
               ? rows
               : "\n## What to use\n\nFor each quantity the settings that none beats in both error and time; "
                 "take the first that is accurate enough.\n\n" +
                     head({"quantity", "error", "setting", "wall time"}) + rows + references_table(report, quantities);
  }

  std::string
  exact_errors_table(const StudyReport &report)
  {
    std::string text;
    for (const std::string norm : {"L1", "L2", "Linf"})
      {
        std::vector<std::size_t> columns;
        std::vector<std::string> names{"method", "cell"};
        for (std::size_t q = 0; q < report.analysis.errors.size(); ++q)
          {
            const Quantity &quantity = report.analysis.errors[q];
            // the distance of the shock stands with the L1 norms
            if (quantity.name != norm && !(norm == "L1" && quantity.name == "distance"))
              continue;
            columns.push_back(q);
            names.insert(names.end(),
                         {quantity.place + (quantity.unit().empty() ? "" : ", " + quantity.unit()), "order"});
          }
        if (columns.empty())
          continue;
        text += "\n### " + norm + "\n\n" + head(names);
        for (const Series &series : report.analysis.series)
          for (const std::size_t i : series.points)
            {
              const double             cell = report.outcomes[i].point.cell;
              std::vector<std::string> line{series.label, cell_text(cell)};
              for (const std::size_t q : columns)
                {
                  const Trend &trend = series.errors[q];
                  std::string  value, order;
                  for (std::size_t l = 0; l < trend.levels.size(); ++l)
                    if (trend.levels[l].cell == cell)
                      {
                        value = digits(trend.levels[l].value, order_digits);
                        order = order_text(trend.orders[l]);
                      }
                  line.insert(line.end(), {value, order});
                }
              text += row(line);
            }
      }
    return text.empty() ? text : "\n## Errors against the exact solution\n" + text;
  }

  std::string
  results_tables(const StudyReport &report)
  {
    std::string text;
    for (const Series &series : report.analysis.series)
      if (series.points.size() > 1 && !report.analysis.results.empty())
        text += results_of(report, series);
    return text.empty()
               ? text
               : "\n## Results and their error bars\n\nThe finest value, its observed order, the limit on ever "
                 "finer cells, and how far the finest value may be from it.\n" +
                     text;
  }

  std::string
  verdicts_table(const StudyReport &report)
  {
    const Series *base = nullptr;
    for (const Series &series : report.analysis.series)
      if (series.label == "base")
        base = &series;
    std::string rows;
    for (const Series &series : report.analysis.series)
      for (const Verdicts &verdict : series.verdicts)
        {
          const auto as_base =
              base && &series != base ? value_on(*base, verdict, verdict.levels.front().first) : std::optional<bool>();
          const bool alone = verdict.levels.size() == 1;
          if (alone && as_base == verdict.levels.front().second)
            continue; // nothing new
          std::string note = alone ? "one cell size only" : flips(verdict);
          if (alone && as_base)
            note = std::string("**other than at the base: ") + (*as_base ? "yes**" : "no**");
          rows +=
              row({series.label, verdict.place + ' ' + split_quantity(verdict.name).words, values_of(verdict), note});
        }
    return rows.empty()
               ? rows
               : "\n## Verdicts\n\nYes or no is a discontinuous functional of the solution: it has no order and no "
                 "error bar, and may flip on finer cells however long it has stayed. A choice that leaves a verdict "
                 "as it is at the base is not listed.\n\n" +
                     head({"method", "verdict", "on cells of", ""}) + rows;
  }
} // namespace whipple::report
