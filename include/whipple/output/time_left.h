// SPDX-License-Identifier: LGPL-2.1-or-later
#pragma once

#include <cstddef>
#include <vector>

namespace whipple
{
  /// How long a chain of stages will still take. What the stages cost was estimated beforehand within a factor; how far
  /// that is off is learnt from what has been done.
  class TimeLeft
  {
  public:
    /// What is left at a moment, wall seconds; not a number where it cannot be told.
    struct Left
    {
      double of_stage;
      double of_run; ///< of_stage and all later stages
    };

    /// @param expected cost of each stage in any unit; 0: unknown
    explicit TimeLeft(std::vector<double> expected);

    /// A stage begins, or goes on. @param wall seconds on any clock
    void
    begin(std::size_t stage, double wall);

    /// @param fraction of the present stage that is done; what was done before the first begin() is not known
    Left
    at(double fraction, double wall) const;

  private:
    std::vector<double> expected_;
    std::size_t         stage_ = 0;
    double              start_ = 0; ///< of the stage, wall seconds
    double              spent_ = 0; ///< in earlier stages
    double              done_  = 0; ///< what they were expected to cost
  };
} // namespace whipple
