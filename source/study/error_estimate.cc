// SPDX-License-Identifier: LGPL-2.1-or-later
#include <whipple/error.h>
#include <whipple/scene/units.h>
#include <whipple/study/cell_ladder.h>
#include <whipple/study/convergence.h>
#include <whipple/study/error_estimate.h>

namespace whipple
{
  namespace
  {
    /// The values of one result on those levels that have it as T.
    template <typename T>
    std::vector<std::pair<double, T>>
    values(const std::vector<LevelResults> &levels, const std::string &place, const std::string &quantity)
    {
      std::vector<std::pair<double, T>> found;
      for (const LevelResults &level : levels)
        if (const auto table = level.results.find(place); table != level.results.end())
          if (const auto entry = table->second.find(quantity); entry != table->second.end())
            if (const T *value = std::get_if<T>(&entry->second))
              found.emplace_back(level.cell, *value);
      return found;
    }

    summary::ErrorBar
    bar_of_number(const std::vector<std::pair<double, double>> &found)
    {
      std::vector<convergence::Level> levels;
      for (const auto &[cell, value] : found)
        levels.push_back({cell, value});
      const convergence::Estimate estimate = convergence::estimate(levels);
      return {estimate.error_bar, estimate.order, estimate.extrapolated, convergence::name(estimate.verdict)};
    }

    summary::ErrorBar
    bar_of_verdict(const std::vector<std::pair<double, bool>> &found)
    {
      bool same = true;
      for (const auto &[cell, value] : found)
        same = same && value == found.back().second;
      return {{}, {}, {}, found.size() == 1 ? "one level" : same ? "the same on all cells" : "flips"};
    }
  } // namespace

  std::vector<Problem<2>>
  coarser_problems(const Scene<2> &scene, const std::vector<std::string> &overrides)
  {
    std::vector<PrmStatement> statements;
    for (const std::string &text : overrides)
      statements.push_back(read_override(text));
    statements.push_back(read_override("Output/Fields interval = none"));
    std::vector<Problem<2>> problems;
    for (int level = scene.output.error_estimate_levels - 1; level > 0; --level)
      {
        const double cell    = scene.lattice.spacing * (1 << level);
        const auto   setting = fit_cell(scene.file, statements, cell);
        if (!setting)
          throw InputError(scene.file, "Output/Error estimate", std::to_string(scene.output.error_estimate_levels),
                           "cells of " + units::format(cell, units::length) +
                               " do not fit the scene; allowed are fewer levels, or none");
        std::vector<PrmStatement> all = statements;
        for (const PrmStatement &statement : setting->overrides("--set"))
          all.push_back(statement);
        problems.push_back(read_varied_problem<2>(scene.file, all));
      }
    return problems;
  }

  std::map<std::string, std::map<std::string, summary::ErrorBar>>
  error_bars(const std::vector<LevelResults> &levels)
  {
    std::map<std::string, std::map<std::string, summary::ErrorBar>> bars;
    for (const auto &[place, table] : levels.back().results)
      for (const auto &[quantity, value] : table)
        if (std::holds_alternative<double>(value))
          bars[place][quantity] = bar_of_number(values<double>(levels, place, quantity));
        else if (std::holds_alternative<bool>(value))
          bars[place][quantity] = bar_of_verdict(values<bool>(levels, place, quantity));
    return bars;
  }
} // namespace whipple
