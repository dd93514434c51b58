// SPDX-License-Identifier: LGPL-2.1-or-later
#include <whipple/output/duration.h>
#include <whipple/study/markdown_table.h>
#include <whipple/study/quantity_name.h>
#include <whipple/study/report_tables.h>

#include <algorithm>
#include <cmath>

namespace whipple::report
{
  namespace
  {
    constexpr int value_digits = 5, change_digits = 2, cost_digits = 3;

    /// Whether a choice changes the result by more than round-off.
    bool
    changes(const ChoiceEffect &effect)
    {
      constexpr double round_off = 1e-12;
      return std::abs(effect.value - effect.base_value) > round_off * std::abs(effect.base_value);
    }

    bool
    matters_more(const ChoiceEffect &effect)
    {
      return effect.mesh_error && std::abs(effect.value - effect.base_value) > *effect.mesh_error;
    }

    std::string
    choice_text(const ChoiceEffect &effect)
    {
      return effect.axis + ": " + effect.base + " → " + effect.label;
    }

    /// Effects on the headlines, those of one choice together.
    std::vector<std::vector<ChoiceEffect>>
    by_choice(const StudyReport &report)
    {
      const std::vector<Quantity>            shown = headlines(report);
      std::vector<std::vector<ChoiceEffect>> groups;
      for (const ChoiceEffect &effect : report.analysis.effects)
        {
          if (std::find(shown.begin(), shown.end(), effect.quantity) == shown.end())
            continue;
          if (groups.empty() || choice_text(groups.back().front()) != choice_text(effect))
            groups.emplace_back();
          groups.back().push_back(effect);
        }
      return groups;
    }

    /// A line for each choice: the results that it changes by more than the mesh does.
    std::string
    choices_overview(const std::vector<std::vector<ChoiceEffect>> &groups)
    {
      std::string rows;
      for (const std::vector<ChoiceEffect> &group : groups)
        {
          std::string more;
          for (const ChoiceEffect &effect : group)
            if (changes(effect) && matters_more(effect))
              more += (more.empty() ? "" : "; ") + effect.quantity.readable() + " (" +
                      digits(effect.value - effect.base_value, change_digits) + " against " +
                      digits(*effect.mesh_error, change_digits) + ")";
          rows += row({choice_text(group.front()), more.empty() ? "nothing" : more});
        }
      return head({"choice", "changes by more than the mesh does"}) + rows;
    }

    std::string
    choices_details(const std::vector<std::vector<ChoiceEffect>> &groups)
    {
      std::string rows;
      for (const std::vector<ChoiceEffect> &group : groups)
        for (const ChoiceEffect &effect : group)
          if (changes(effect))
            rows += row({choice_text(effect), effect.quantity.readable(), cell_text(effect.cell),
                         digits(effect.base_value, value_digits) + " → " + digits(effect.value, value_digits),
                         digits(effect.value - effect.base_value, change_digits),
                         effect.mesh_error ? digits(*effect.mesh_error, change_digits) : ""});
      return rows.empty() ? rows
                          : "\nAll changes; what is not listed stays as it is.\n\n" +
                                head({"choice", "result", "cell", "values", "change", "mesh"}) + rows;
    }
  } // namespace

  std::string
  choices_table(const StudyReport &report)
  {
    const std::vector<std::vector<ChoiceEffect>> groups = by_choice(report);
    if (groups.empty())
      return {};
    return "\n## Choices beside the mesh\n\nWhat another choice changes, all else as at the base, beside what the "
           "cells of "
           "that size leave open: the distance of the base's result from its limit, and what that may be wrong "
           "by.\n\n" +
           choices_overview(groups) + choices_details(groups);
  }

  std::string
  costs_table(const StudyReport &report)
  {
    constexpr double mega = 1e6, bytes_per_mb = 1048576;
    std::string      text =
        "\n## Price of every point\n\n" + head({"point", "ranks", "wall", "CPU", "steps", "million active cell-steps",
                                                "peak memory, MB", "energy lost", "energy dropped", "mass dropped"});
    const auto per_cent = [](double part) { return digits(100. * part, change_digits) + " %"; };
    for (const PointOutcome &outcome : report.outcomes)
      {
        const PointRecord &r = outcome.record;
        if (r.status == "crashed")
          continue;
        text += row({point_name(report.plan.section, outcome.point.choice), std::to_string(outcome.point.ranks),
                     duration(r.cost.wall_s), duration(r.cost.cpu_s), std::to_string(r.cost.steps),
                     digits(r.cost.active_cell_steps / mega, cost_digits),
                     digits(r.cost.peak_rss_bytes / bytes_per_mb, cost_digits), per_cent(r.losses.energy_lost),
                     per_cent(r.losses.energy_dropped), per_cent(r.losses.mass_dropped)});
      }
    return text;
  }
} // namespace whipple::report
