// SPDX-License-Identifier: LGPL-2.1-or-later
#pragma once

#include <whipple/study/analysis.h>
#include <whipple/study/tolerance_run.h>

#include <string>
#include <vector>

/// What a study leaves: study.csv, study.md and study.json. Their contents are described in doc/studies.md.
namespace whipple::report
{
  /// Everything there is to write down.
  struct StudyReport
  {
    StudyOptions                    options;
    StudyPlan                       plan;
    std::vector<PointOutcome>       outcomes; ///< coarse to fine
    StudyAnalysis                   analysis;
    std::optional<ToleranceVerdict> tolerance; ///< if the study was asked for one
  };

  /// Quantities for the first tables and the plots: the L1 errors and the shock position where there is an exact
  /// solution; the results that the study names, or else up to six that matter most.
  std::vector<Quantity>
  headlines(const StudyReport &report);

  /// The results that go into tables: those that the study names, or else all if there are no errors against an exact
  /// solution to show.
  bool
  in_tables(const StudyReport &report, const Quantity &result);

  /// A row for each point, with all numbers.
  std::string
  csv(const StudyReport &report);

  /// Tables to read.
  std::string
  markdown(const StudyReport &report);

  /// Everything, for scripts/plot_study.py and other programs.
  std::string
  json(const StudyReport &report);

  /// Write the three files into the study's directory, each in one piece.
  /// @throws Error if the disk refuses.
  void
  write(const StudyReport &report);
} // namespace whipple::report
