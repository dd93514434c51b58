// SPDX-License-Identifier: LGPL-2.1-or-later
#pragma once

#include <optional>
#include <string>
#include <utility>
#include <vector>

namespace whipple
{
  /// The time steps of a stage, in order, so that a collapse is noticed: a run that goes on with steps a thousandth of
  /// a thousandth of what they were never ends, and what makes them so small is wrong long before.
  class TimeStepHistory
  {
  public:
    TimeStepHistory() = default;
    /// Go on with steps made before, us.
    explicit TimeStepHistory(std::vector<double> steps)
      : steps_(std::move(steps))
    {
    }

    const std::vector<double> &
    steps() const
    {
      return steps_;
    }

    /// A step was made. @param dt us; not one that was cut because the stage ends
    void
    add(double dt);

    /// What has collapsed, if it has, in words with the numbers: the last 100 steps all below 1e-4 of the median of
    /// those before them, or below 1e-6 of the largest of the first ten. Looks at every hundredth step.
    std::optional<std::string>
    collapse() const;

    /// What a step of the stage is like, us: the larger of the median as of the last hundredth step and the largest of
    /// the first ten; 0 before there are a hundred.
    double
    typical();

  private:
    static constexpr std::size_t window = 100;

    std::vector<double> steps_;        ///< us
    std::size_t         asked_at_ = 0; ///< steps that typical_ is of
    double              typical_  = 0;
  };
} // namespace whipple
