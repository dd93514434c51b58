// SPDX-License-Identifier: LGPL-2.1-or-later
#pragma once

#include <whipple/study/child_run.h>
#include <whipple/study/cost_law.h>
#include <whipple/study/point_record.h>
#include <whipple/study/study_plan.h>

#include <ostream>
#include <string>
#include <vector>

namespace whipple
{
  /// A point with what came out of it.
  struct PointOutcome
  {
    StudyPoint  point;
    PointRecord record;
  };

  /// Runs points of a study one after the other, each as a process of its own in its own directory, and tells how far
  /// it is. Points that are there already are taken as they are. A point that stops or crashes is recorded with its
  /// reason; the study goes on.
  class StudyRunner
  {
  public:
    /// @param output progress goes there; refreshed in place if options.live
    StudyRunner(const StudyOptions &options, std::ostream &output);

    /// Run, or find, these points of a plan.
    std::vector<PointOutcome>
    run(const StudyPlan &plan, const std::vector<StudyPoint> &points);

    /// Seconds a point will take, as far as it can be told from the points so far.
    std::optional<double>
    forecast(const StudyPlan &plan, const StudyPoint &point) const;

  private:
    /// What is there of each time a point is run.
    using Repeats = std::vector<std::optional<PointRecord>>;

    std::vector<Repeats>
    find(const StudyPlan &plan, const std::vector<StudyPoint> &points);
    PointRecord
    compute(const StudyPlan &plan, const StudyPoint &point, int repeat, const std::string &title);
    /// @returns how it ended
    std::string
    wait_for(ChildRun &&child, const std::string &title, std::optional<double> expected);
    void
    learn(const StudyPlan &plan, const StudyPoint &point, const PointRecord &record);
    /// "; the whole takes about 3 min" or nothing
    std::string
    whole(const StudyPlan &plan, const std::vector<StudyPoint> &todo) const;
    void
    refresh(const std::string &line);
    void
    say(const std::string &line);

    StudyOptions  options_;
    std::ostream &output_;
    CostForecast  forecast_;
    std::size_t   live_width_ = 0; ///< characters of the line being refreshed
  };
} // namespace whipple
