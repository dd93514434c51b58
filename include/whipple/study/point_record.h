// SPDX-License-Identifier: LGPL-2.1-or-later
#pragma once

#include <whipple/output/summary.h>
#include <whipple/study/study_plan.h>

#include <map>
#include <optional>
#include <string>
#include <vector>

namespace whipple
{
  /// What a point has cost.
  struct PointCost
  {
    double wall_s            = 0; ///< median of the repeats
    double cpu_s             = 0; ///< median of the repeats, all ranks
    double peak_rss_bytes    = 0; ///< all ranks
    double active_cell_steps = 0;
    long   steps             = 0;
    int    repeats           = 1;
  };

  /// What a point has lost on its way, as parts of what was introduced.
  struct PointLosses
  {
    double energy_lost    = 0; ///< kinetic energy taken by remap, regrids, projections and released fragments
    double energy_dropped = 0; ///< energy of what was taken out on purpose
    double mass_dropped   = 0;
    double energy_closure = 0; ///< error of the energy ledger
  };

  /// What came out of a point: its summary.json, or why there is none.
  struct PointRecord
  {
    std::string program;            ///< "0.1.0 (46557a3), Release"
    std::string status = "crashed"; ///< "completed", "stopped", "crashed"
    std::string reason;             ///< why not completed
    bool        reused = false;     ///< computed before this study was started
    PointCost   cost;
    PointLosses losses;

    std::map<std::string, std::map<std::string, summary::Result>> results; ///< place -> quantity -> value
    std::map<std::string, std::map<std::string, double>>          errors;  ///< field -> norm -> value

    bool
    completed() const
    {
      return status == "completed";
    }
    /// The number a result is; none if it is null, no number, or not there.
    std::optional<double>
    number(const std::string &place, const std::string &quantity) const;
  };

  /// The version of this program, as PointRecord::program names it.
  std::string
  this_program();

  /// The record in a directory if it is that of this point: complete, with the same parameters and number of ranks,
  /// computed by this version of the program (`any_version`: by any). A program built from uncommitted sources is
  /// the same version only for points younger than itself.
  std::optional<PointRecord>
  find_record(const std::string &directory, const StudyPoint &point, bool any_version);

  /// Whether a run of this point was ended before it was complete and left checkpoints to go on from.
  bool
  can_go_on(const std::string &directory, const StudyPoint &point);

  /// One record of a point that was run several times: the first that did not complete, else the first, with the median
  /// of the times. @pre every repeat is there
  PointRecord
  median_record(const std::vector<std::optional<PointRecord>> &repeats);
} // namespace whipple
