// SPDX-License-Identifier: LGPL-2.1-or-later
#include <whipple/diagnostics/result_table.h>
#include <whipple/study/analysis.h>
#include <whipple/study/quantity_name.h>

#include <algorithm>
#include <cmath>
#include <set>

namespace whipple
{
  namespace
  {
    constexpr const char *shock_field = "shock position", *shock_norm = "distance";

    using Outcomes = std::vector<PointOutcome>;

    /// Errors against the exact solution that some point has.
    std::vector<Quantity>
    known_errors(const Outcomes &outcomes)
    {
      std::set<Quantity> found;
      for (const PointOutcome &outcome : outcomes)
        {
          for (const auto &[field, norms] : outcome.record.errors)
            for (const char *norm : {"L1", "L2", "Linf"})
              if (norms.contains(norm))
                found.insert({true, field, norm});
          const Quantity shock{true, shock_field, shock_norm};
          if (value_of(outcome.record, shock))
            found.insert(shock);
        }
      return {found.begin(), found.end()};
    }

    /// Results that are numbers at some point.
    std::vector<Quantity>
    known_results(const Outcomes &outcomes)
    {
      std::set<Quantity> found;
      for (const PointOutcome &outcome : outcomes)
        for (const auto &[place, table] : outcome.record.results)
          for (const auto &[name, value] : table)
            if (std::holds_alternative<double>(value))
              found.insert({false, place, name});
      return {found.begin(), found.end()};
    }

    Trend
    trend_of(const Series &series, const Outcomes &outcomes, const Quantity &quantity)
    {
      Trend trend{quantity, {}, {}, {}};
      for (const std::size_t i : series.points)
        if (const auto value = value_of(outcomes[i].record, quantity))
          trend.levels.push_back({outcomes[i].point.cell, *value});
      for (std::size_t l = 0; l < trend.levels.size(); ++l)
        {
          std::optional<double> order;
          if (quantity.exact && l >= 1)
            order = convergence::order_of_errors(trend.levels[l - 1], trend.levels[l]);
          if (!quantity.exact && l >= 2)
            order = convergence::order_of_values(trend.levels[l - 2], trend.levels[l - 1], trend.levels[l]);
          trend.orders.push_back(order);
        }
      if (!quantity.exact && !trend.levels.empty())
        trend.estimate = convergence::estimate(trend.levels);
      return trend;
    }

    std::vector<Verdicts>
    verdicts_of(const Series &series, const Outcomes &outcomes)
    {
      std::map<std::pair<std::string, std::string>, std::vector<std::pair<double, bool>>> found;
      for (const std::size_t i : series.points)
        for (const auto &[place, table] : outcomes[i].record.results)
          for (const auto &[name, value] : table)
            if (std::holds_alternative<bool>(value))
              found[{place, name}].emplace_back(outcomes[i].point.cell, std::get<bool>(value));
      std::vector<Verdicts> verdicts;
      for (const auto &[name, levels] : found)
        verdicts.push_back({name.first, name.second, levels});
      return verdicts;
    }

    /// Points of a series, coarse to fine, as the outcomes already are. Points that stopped have no part in it.
    std::vector<Series>
    collect_series(const StudyPlan &plan, const Outcomes &outcomes)
    {
      std::vector<Series> all;
      for (std::size_t i = 0; i < outcomes.size(); ++i)
        {
          if (!outcomes[i].record.completed())
            continue;
          const auto       &choice = outcomes[i].point.choice;
          const std::string label  = method_name(plan.section, choice);
          auto found = std::find_if(all.begin(), all.end(), [&](const Series &s) { return s.label == label; });
          if (found == all.end())
            found = all.insert(all.end(), {label, choice, {}, {}, {}, {}});
          found->points.push_back(i);
        }
      return all;
    }

    /// The trend of three levels or more with the smallest error bar; else of those the finest value.
    std::optional<Reference>
    reference_of(const std::vector<Series> &all, std::size_t quantity)
    {
      const Trend  *best = nullptr;
      const Series *from = nullptr;
      const auto    rank = [](const Trend &t) {
        const bool judged = t.levels.size() >= 3;
        return std::make_tuple(!judged, judged ? *t.estimate.error_bar : 0., t.levels.back().cell);
      };
      for (const Series &series : all)
        {
          const Trend &trend = series.results[quantity];
          if (!trend.levels.empty() && (!best || rank(trend) < rank(*best)))
            {
              best = &trend;
              from = &series;
            }
        }
      if (!best)
        return std::nullopt;
      return Reference{best->quantity, best->estimate.limit(), best->estimate.limit_uncertainty(), from->label};
    }

    std::optional<double>
    mesh_error(const Trend &trend, double value)
    {
      if (trend.levels.size() < 2)
        return std::nullopt;
      return std::abs(value - trend.estimate.limit()) + trend.estimate.limit_uncertainty();
    }

    bool
    is_model_choice(const StudyAxis &axis)
    {
      return !axis.is_cell_axis() && axis.parameters != std::vector<std::string>{ranks_parameter};
    }

    const PointOutcome *
    find_point(const Outcomes &outcomes, const std::vector<std::size_t> &choice)
    {
      for (const PointOutcome &outcome : outcomes)
        if (outcome.point.choice == choice && outcome.record.completed())
          return &outcome;
      return nullptr;
    }

    std::vector<ChoiceEffect>
    choice_effects(const StudyPlan &plan, const Outcomes &outcomes, const StudyAnalysis &analysis)
    {
      std::vector<ChoiceEffect> effects;
      std::vector<std::size_t>  base;
      for (const StudyAxis &axis : plan.section.axes)
        base.push_back(axis.base);
      const PointOutcome *base_point = find_point(outcomes, base);
      if (!base_point)
        return effects;
      const std::string label  = method_name(plan.section, base);
      const auto        series = std::find_if(analysis.series.begin(), analysis.series.end(),
                                              [&](const Series &s) { return s.label == label; });
      for (std::size_t a = 0; a < base.size(); ++a)
        for (std::size_t v = 0; is_model_choice(plan.section.axes[a]) && v < plan.section.axes[a].values.size(); ++v)
          {
            std::vector<std::size_t> choice = base;
            choice[a]                       = v;
            const PointOutcome *point       = v == base[a] ? nullptr : find_point(outcomes, choice);
            for (std::size_t q = 0; point && q < analysis.results.size(); ++q)
              {
                const StudyAxis &axis = plan.section.axes[a];
                const auto       from = value_of(base_point->record, analysis.results[q]);
                const auto       to   = value_of(point->record, analysis.results[q]);
                if (from && to)
                  effects.push_back({analysis.results[q], axis.name, axis.values[v].label, axis.values[base[a]].label,
                                     point->point.cell, *from, *to, mesh_error(series->results[q], *from)});
              }
          }
      return effects;
    }
  } // namespace

  std::string
  Quantity::readable() const
  {
    const std::string in = unit().empty() ? "" : ", " + unit();
    return exact ? place + (name == shock_norm ? " error" : " " + name) + in
                 : place + ' ' + split_quantity(name).words + in;
  }

  std::string
  Quantity::unit() const
  {
    return exact ? field_unit(place) : split_quantity(name).unit;
  }

  std::optional<double>
  value_of(const PointRecord &record, const Quantity &quantity)
  {
    if (!quantity.exact)
      return record.number(quantity.place, quantity.name);
    if (quantity.name == shock_norm)
      {
        const auto found = record.number(exact_place, "shock_position_cm");
        const auto exact = record.number(exact_place, "shock_position_exact_cm");
        return found && exact ? std::optional<double>(std::abs(*found - *exact)) : std::nullopt;
      }
    const auto field = record.errors.find(quantity.place);
    if (field == record.errors.end() || !field->second.contains(quantity.name))
      return std::nullopt;
    return field->second.at(quantity.name);
  }

  const Reference *
  StudyAnalysis::reference(const Quantity &quantity) const
  {
    for (const Reference &reference : references)
      if (reference.quantity == quantity)
        return &reference;
    return nullptr;
  }

  StudyAnalysis
  analyse(const StudyPlan &plan, const std::vector<PointOutcome> &outcomes)
  {
    StudyAnalysis analysis;
    analysis.errors  = known_errors(outcomes);
    analysis.results = known_results(outcomes);
    analysis.series  = collect_series(plan, outcomes);
    for (Series &series : analysis.series)
      {
        for (const Quantity &quantity : analysis.errors)
          series.errors.push_back(trend_of(series, outcomes, quantity));
        for (const Quantity &quantity : analysis.results)
          series.results.push_back(trend_of(series, outcomes, quantity));
        series.verdicts = verdicts_of(series, outcomes);
      }
    for (std::size_t q = 0; q < analysis.results.size(); ++q)
      if (const auto reference = reference_of(analysis.series, q))
        analysis.references.push_back(*reference);
    analysis.effects = choice_effects(plan, outcomes, analysis);
    return analysis;
  }

  std::optional<PointError>
  point_error(const StudyAnalysis &analysis, const PointRecord &record, const Quantity &quantity)
  {
    const auto value = value_of(record, quantity);
    if (!value)
      return std::nullopt;
    if (quantity.exact)
      return PointError{*value, 0., false};
    const Reference *reference = analysis.reference(quantity);
    // a limit that may as well be 0 is nothing to be relative to
    const bool   relative = std::abs(reference->value) > reference->uncertainty;
    const double scale    = relative ? std::abs(reference->value) : 1.;
    return PointError{std::abs(*value - reference->value) / scale, reference->uncertainty / scale, relative};
  }
} // namespace whipple
