// SPDX-License-Identifier: LGPL-2.1-or-later
#pragma once

#include <whipple/study/report.h>

#include <string>

/// The tables of study.md, each with its heading; empty where there is nothing to tell.
namespace whipple::report
{
  /// For each headline the settings that no other beats in both error and time.
  std::string
  what_to_use(const StudyReport &report);

  /// Errors against the exact solution with the order between each pair of levels, a table for each norm.
  std::string
  exact_errors_table(const StudyReport &report);

  /// Results of each series: values, order, limit, error bar, and what kind of convergence that is.
  std::string
  results_tables(const StudyReport &report);

  /// Verdicts (yes or no): the same on all cells, or where they flip.
  std::string
  verdicts_table(const StudyReport &report);

  /// What each choice changes, beside what the mesh does.
  std::string
  choices_table(const StudyReport &report);

  /// Price of every point, and what it loses.
  std::string
  costs_table(const StudyReport &report);
} // namespace whipple::report
