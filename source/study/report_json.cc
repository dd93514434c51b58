// SPDX-License-Identifier: LGPL-2.1-or-later
#include <whipple/study/quantity_name.h>
#include <whipple/study/report.h>

#include <nlohmann/json.hpp>

#include <algorithm>
#include <cmath>
#include <filesystem>

namespace whipple::report
{
  namespace
  {
    constexpr int schema = 1;

    using Json = nlohmann::ordered_json;

    Json
    number(double value)
    {
      return std::isfinite(value) ? Json(value) : Json(nullptr);
    }

    Json
    number(const std::optional<double> &value)
    {
      return value ? number(*value) : Json(nullptr);
    }

    struct ResultToJson
    {
      Json
      operator()(std::monostate) const
      {
        return nullptr;
      }
      Json
      operator()(double value) const
      {
        return number(value);
      }
      Json
      operator()(bool value) const
      {
        return value;
      }
      Json
      operator()(const std::string &value) const
      {
        return value;
      }
    };

    Json
    json_of(const Quantity &quantity)
    {
      return {{"exact", quantity.exact},
              {"place", quantity.place},
              {"name", quantity.name},
              {"readable", quantity.readable()},
              {"unit", quantity.unit()}};
    }

    Json
    axes(const StudySection &section)
    {
      Json all = Json::array();
      for (const StudyAxis &axis : section.axes)
        {
          Json labels = Json::array();
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

    Json
    point(const StudyReport &report, const PointOutcome &outcome)
    {
      const PointRecord &record  = outcome.record;
      Json               choices = Json::object(), results = Json::object(), errors = Json::object();
      for (std::size_t a = 0; a < outcome.point.choice.size(); ++a)
        choices[report.plan.section.axes[a].name] = report.plan.section.axes[a].values[outcome.point.choice[a]].label;
      for (const auto &[place, table] : record.results)
        for (const auto &[name, value] : table)
          results[place][name] = std::visit(ResultToJson{}, value);
      for (const auto &[field, norms] : record.errors)
        for (const auto &[norm, value] : norms)
          errors[field][norm] = number(value);
      Json headline = Json::array();
      for (const Quantity &quantity : headlines(report))
        {
          const auto error = point_error(report.analysis, record, quantity);
          headline.push_back(error && record.completed() ? Json{{"error", number(error->error)},
                                                                {"uncertainty", number(error->uncertainty)},
                                                                {"relative", error->relative}}
                                                         : Json(nullptr));
        }
      return {{"label", outcome.point.label},
              {"choices", choices},
              {"cell_cm", number(outcome.point.cell)},
              {"ranks", outcome.point.ranks},
              {"program", record.program},
              {"status", record.status},
              {"reason", record.reason.empty() ? Json(nullptr) : Json(record.reason)},
              {"wall_s", number(record.cost.wall_s)},
              {"cpu_s", number(record.cost.cpu_s)},
              {"repeats", record.cost.repeats},
              {"steps", record.cost.steps},
              {"active_cell_steps", number(record.cost.active_cell_steps)},
              {"peak_rss_bytes", number(record.cost.peak_rss_bytes)},
              {"energy_lost_part", number(record.losses.energy_lost)},
              {"energy_dropped_part", number(record.losses.energy_dropped)},
              {"mass_dropped_part", number(record.losses.mass_dropped)},
              {"energy_closure", number(record.losses.energy_closure)},
              {"headline_errors", headline},
              {"errors", errors},
              {"results", results}};
    }

    Json
    json_of(const Trend &trend)
    {
      Json cells = Json::array(), values = Json::array(), orders = Json::array();
      for (const convergence::Level &level : trend.levels)
        {
          cells.push_back(number(level.cell));
          values.push_back(number(level.value));
        }
      for (const auto &order : trend.orders)
        orders.push_back(number(order));
      Json json = {{"quantity", json_of(trend.quantity)}, {"cells_cm", cells}, {"values", values}, {"orders", orders}};
      if (!trend.quantity.exact && !trend.levels.empty())
        json["estimate"] = {{"verdict", convergence::name(trend.estimate.verdict)},
                            {"order", number(trend.estimate.order)},
                            {"extrapolated", number(trend.estimate.extrapolated)},
                            {"error_bar", number(trend.estimate.error_bar)}};
      return json;
    }

    Json
    json_of(const Series &series, const std::vector<PointOutcome> &outcomes)
    {
      Json points = Json::array(), errors = Json::array(), results = Json::array(), verdicts = Json::array();
      for (const std::size_t i : series.points)
        points.push_back(outcomes[i].point.label);
      for (const Trend &trend : series.errors)
        errors.push_back(json_of(trend));
      for (const Trend &trend : series.results)
        results.push_back(json_of(trend));
      for (const Verdicts &verdict : series.verdicts)
        {
          Json levels = Json::array();
          for (const auto &[cell, yes] : verdict.levels)
            levels.push_back({{"cell_cm", number(cell)}, {"value", yes}});
          verdicts.push_back({{"place", verdict.place}, {"name", verdict.name}, {"levels", levels}});
        }
      return {{"label", series.label},
              {"points", points},
              {"errors", errors},
              {"results", results},
              {"verdicts", verdicts}};
    }

    Json
    json_of(const ChoiceEffect &effect)
    {
      return {{"quantity", json_of(effect.quantity)},
              {"axis", effect.axis},
              {"label", effect.label},
              {"base", effect.base},
              {"cell_cm", number(effect.cell)},
              {"base_value", number(effect.base_value)},
              {"value", number(effect.value)},
              {"mesh_error", number(effect.mesh_error)}};
    }

    Json
    json_of(const ToleranceVerdict &verdict)
    {
      Json methods = Json::array();
      for (const MethodForecast &method : verdict.methods)
        {
          Json rows = Json::array();
          for (const CellForecast &row : method.rows)
            rows.push_back({{"cell_cm", number(row.cell)},
                            {"expected_error", number(row.error)},
                            {"expected_s", number(row.seconds)},
                            {"has_run", row.computed}});
          methods.push_back({{"label", method.label},
                             {"excluded", method.excluded.empty() ? Json(nullptr) : Json(method.excluded)},
                             {"verdict", method.verdict},
                             {"order", number(method.error.exponent)},
                             {"rows", rows}});
        }
      return {{"text", verdict.tolerance.text},
              {"quantity", json_of(verdict.tolerance.quantity)},
              {"amount", number(verdict.tolerance.amount)},
              {"relative", verdict.tolerance.relative},
              {"budget_s", number(verdict.budget_s)},
              {"methods", methods},
              {"expected_error", verdict.method ? number(verdict.chosen.error) : Json(nullptr)},
              {"expected_s", verdict.method ? number(verdict.chosen.seconds) : Json(nullptr)},
              {"error", number(verdict.final_error)},
              {"wall_s", verdict.final_error ? number(verdict.final_seconds) : Json(nullptr)},
              {"conclusion", verdict.conclusion}};
    }
  } // namespace

  std::string
  json(const StudyReport &report)
  {
    Json points = Json::array(), series = Json::array(), references = Json::array(), effects = Json::array(),
         headline = Json::array();
    for (const PointOutcome &outcome : report.outcomes)
      points.push_back(point(report, outcome));
    for (const Series &one : report.analysis.series)
      series.push_back(json_of(one, report.outcomes));
    for (const Reference &reference : report.analysis.references)
      references.push_back({{"quantity", json_of(reference.quantity)},
                            {"value", number(reference.value)},
                            {"uncertainty", number(reference.uncertainty)},
                            {"series", reference.series}});
    for (const ChoiceEffect &effect : report.analysis.effects)
      effects.push_back(json_of(effect));
    for (const Quantity &quantity : headlines(report))
      headline.push_back(json_of(quantity));
    const Json document = {
        {"schema", schema},           {"study", std::filesystem::path(report.plan.file).filename().string()},
        {"title", report.plan.title}, {"command", report.options.command},
        {"program", this_program()},  {"axes", axes(report.plan.section)},
        {"headlines", headline},      {"points", points},
        {"series", series},           {"references", references},
        {"choices", effects},         {"tolerance", report.tolerance ? json_of(*report.tolerance) : Json(nullptr)}};
    return document.dump(1, ' ', false, Json::error_handler_t::replace) + '\n';
  }
} // namespace whipple::report
