// SPDX-License-Identifier: LGPL-2.1-or-later
#include <whipple/output/json_value.h>
#include <whipple/study/quantity_name.h>
#include <whipple/study/report.h>

#include <algorithm>
#include <cmath>
#include <filesystem>

namespace whipple::report
{
  namespace
  {
    constexpr int schema = 1;

    json::Json
    json_of(const Quantity &quantity)
    {
      return {{"exact", quantity.exact},
              {"place", quantity.place},
              {"name", quantity.name},
              {"readable", quantity.readable()},
              {"unit", quantity.unit()}};
    }

    json::Json
    axes(const StudySection &section)
    {
      json::Json all = json::Json::array();
      for (const StudyAxis &axis : section.axes)
        {
          json::Json labels = json::Json::array();
          for (const StudyValue &value : axis.values)
            labels.push_back(value.label);
          all.push_back({{"name", axis.name},
                         {"parameters", axis.parameters},
                         {"labels", labels},
                         {"base", axis.values[axis.base].label},
                         {"is_cell_axis", axis.is_cell_axis()}});
        }
      return all;
    }

    json::Json
    point(const StudyReport &report, const PointOutcome &outcome)
    {
      const PointRecord &record  = outcome.record;
      json::Json         choices = json::Json::object(), results = json::Json::object(), errors = json::Json::object();
      for (std::size_t a = 0; a < outcome.point.choice.size(); ++a)
        choices[report.plan.section.axes[a].name] = report.plan.section.axes[a].values[outcome.point.choice[a]].label;
      for (const auto &[place, table] : record.results)
        for (const auto &[name, value] : table)
          results[place][name] = json::value(value);
      for (const auto &[field, norms] : record.errors)
        for (const auto &[norm, value] : norms)
          errors[field][norm] = json::value(value);
      json::Json headline = json::Json::array();
      for (const Quantity &quantity : headlines(report))
        {
          const auto error = point_error(report.analysis, record, quantity);
          headline.push_back(error && record.completed() ? json::Json{{"error", json::value(error->error)},
                                                                      {"uncertainty", json::value(error->uncertainty)},
                                                                      {"relative", error->relative}}
                                                         : json::Json(nullptr));
        }
      return {{"label", outcome.point.label},
              {"choices", choices},
              {"cell_cm", json::value(outcome.point.cell)},
              {"ranks", outcome.point.ranks},
              {"program", record.program},
              {"status", record.status},
              {"reason", record.reason.empty() ? json::Json(nullptr) : json::Json(record.reason)},
              {"wall_s", json::value(record.cost.wall_s)},
              {"cpu_s", json::value(record.cost.cpu_s)},
              {"repeats", record.cost.repeats},
              {"steps", record.cost.steps},
              {"active_cell_steps", json::value(record.cost.active_cell_steps)},
              {"peak_rss_bytes", json::value(record.cost.peak_rss_bytes)},
              {"energy_lost_part", json::value(record.losses.energy_lost)},
              {"energy_dropped_part", json::value(record.losses.energy_dropped)},
              {"mass_dropped_part", json::value(record.losses.mass_dropped)},
              {"energy_closure", json::value(record.losses.energy_closure)},
              {"headline_errors", headline},
              {"errors", errors},
              {"results", results}};
    }

    json::Json
    json_of(const Trend &trend)
    {
      json::Json cells = json::Json::array(), values = json::Json::array(), orders = json::Json::array();
      for (const convergence::Level &level : trend.levels)
        {
          cells.push_back(json::value(level.cell));
          values.push_back(json::value(level.value));
        }
      for (const auto &order : trend.orders)
        orders.push_back(json::value(order));
      json::Json json = {
          {"quantity", json_of(trend.quantity)}, {"cells_cm", cells}, {"values", values}, {"orders", orders}};
      if (!trend.quantity.exact && !trend.levels.empty())
        json["estimate"] = {{"verdict", convergence::name(trend.estimate.verdict)},
                            {"order", json::value(trend.estimate.order)},
                            {"extrapolated", json::value(trend.estimate.extrapolated)},
                            {"error_bar", json::value(trend.estimate.error_bar)}};
      return json;
    }

    json::Json
    json_of(const Series &series, const std::vector<PointOutcome> &outcomes)
    {
      json::Json points = json::Json::array(), errors = json::Json::array(), results = json::Json::array(),
                 verdicts = json::Json::array();
      for (const std::size_t i : series.points)
        points.push_back(outcomes[i].point.label);
      for (const Trend &trend : series.errors)
        errors.push_back(json_of(trend));
      for (const Trend &trend : series.results)
        results.push_back(json_of(trend));
      for (const Verdicts &verdict : series.verdicts)
        {
          json::Json levels = json::Json::array();
          for (const auto &[cell, yes] : verdict.levels)
            levels.push_back({{"cell_cm", json::value(cell)}, {"value", yes}});
          verdicts.push_back({{"place", verdict.place}, {"name", verdict.name}, {"levels", levels}});
        }
      return {{"label", series.label},
              {"points", points},
              {"errors", errors},
              {"results", results},
              {"verdicts", verdicts}};
    }

    json::Json
    json_of(const ChoiceEffect &effect)
    {
      return {{"quantity", json_of(effect.quantity)},
              {"axis", effect.axis},
              {"label", effect.label},
              {"base", effect.base},
              {"cell_cm", json::value(effect.cell)},
              {"base_value", json::value(effect.base_value)},
              {"value", json::value(effect.value)},
              {"mesh_error", json::value(effect.mesh_error)}};
    }

    json::Json
    json_of(const ToleranceVerdict &verdict)
    {
      json::Json methods = json::Json::array();
      for (const MethodForecast &method : verdict.methods)
        {
          json::Json rows = json::Json::array();
          for (const CellForecast &row : method.rows)
            rows.push_back({{"cell_cm", json::value(row.cell)},
                            {"expected_error", json::value(row.error)},
                            {"expected_s", json::value(row.seconds)},
                            {"has_run", row.computed}});
          methods.push_back({{"label", method.label},
                             {"excluded", method.excluded.empty() ? json::Json(nullptr) : json::Json(method.excluded)},
                             {"verdict", method.verdict},
                             {"order", json::value(method.error.exponent)},
                             {"rows", rows}});
        }
      return {{"text", verdict.tolerance.text},
              {"quantity", json_of(verdict.tolerance.quantity)},
              {"amount", json::value(verdict.tolerance.amount)},
              {"relative", verdict.tolerance.relative},
              {"budget_s", json::value(verdict.budget_s)},
              {"methods", methods},
              {"expected_error", verdict.method ? json::value(verdict.chosen.error) : json::Json(nullptr)},
              {"expected_s", verdict.method ? json::value(verdict.chosen.seconds) : json::Json(nullptr)},
              {"error", json::value(verdict.final_error)},
              {"wall_s", verdict.final_error ? json::value(verdict.final_seconds) : json::Json(nullptr)},
              {"conclusion", verdict.conclusion}};
    }
  } // namespace

  std::string
  json(const StudyReport &report)
  {
    json::Json points = json::Json::array(), series = json::Json::array(), references = json::Json::array(),
               effects = json::Json::array(), headline = json::Json::array();
    for (const PointOutcome &outcome : report.outcomes)
      points.push_back(point(report, outcome));
    for (const Series &one : report.analysis.series)
      series.push_back(json_of(one, report.outcomes));
    for (const Reference &reference : report.analysis.references)
      references.push_back({{"quantity", json_of(reference.quantity)},
                            {"value", json::value(reference.value)},
                            {"uncertainty", json::value(reference.uncertainty)},
                            {"series", reference.series}});
    for (const ChoiceEffect &effect : report.analysis.effects)
      effects.push_back(json_of(effect));
    for (const Quantity &quantity : headlines(report))
      headline.push_back(json_of(quantity));
    const json::Json document = {{"schema", schema},
                                 {"study", std::filesystem::path(report.plan.file).filename().string()},
                                 {"title", report.plan.title},
                                 {"command", report.options.command},
                                 {"program", this_program()},
                                 {"axes", axes(report.plan.section)},
                                 {"headlines", headline},
                                 {"points", points},
                                 {"series", series},
                                 {"references", references},
                                 {"choices", effects},
                                 {"tolerance", report.tolerance ? json_of(*report.tolerance) : json::Json(nullptr)}};
    return document.dump(1, ' ', false, json::Json::error_handler_t::replace) + '\n';
  }
} // namespace whipple::report
