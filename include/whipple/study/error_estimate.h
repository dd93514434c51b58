// SPDX-License-Identifier: LGPL-2.1-or-later
#pragma once

#include <whipple/diagnostics/result_table.h>
#include <whipple/problem/problem.h>

#include <map>
#include <string>
#include <vector>

/// Error bars of the results of one run, from the same scene on cells twice and four times as large.
namespace whipple
{
  /// Results of a run on cells of some size (cm).
  struct LevelResults
  {
    double                             cell = 0;
    std::map<std::string, ResultTable> results;
  };

  /// The scenes that go with `scene` (which was read from that file with these overrides), coarsest first: cells 2, 4
  /// ... times its own, levels fitted so that the domain stays what it is, no field files.
  /// @throws InputError naming Output/Error estimate if the scene cannot be set on such cells.
  std::vector<Problem<2>>
  coarser_problems(const Scene<2> &scene, const std::vector<std::string> &overrides);

  /// Error bars of the finest level's results (convergence::estimate): numbers with error, verdicts (yes or no) with
  /// "the same on all cells" or "flips".
  /// @param levels the finest last
  std::map<std::string, std::map<std::string, summary::ErrorBar>>
  error_bars(const std::vector<LevelResults> &levels);
} // namespace whipple
