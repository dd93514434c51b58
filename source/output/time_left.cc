// SPDX-License-Identifier: LGPL-2.1-or-later
#include <whipple/output/time_left.h>

#include <limits>
#include <utility>

namespace whipple
{
  TimeLeft::TimeLeft(std::vector<double> expected)
    : expected_(std::move(expected))
    , stage_(expected_.size())
  {
  }

  void
  TimeLeft::begin(std::size_t stage, double wall)
  {
    if (stage_ < expected_.size() && stage_ != stage)
      {
        spent_ += wall - start_;
        done_ += expected_[stage_];
      }
    stage_ = stage;
    start_ = wall;
  }

  TimeLeft::Left
  TimeLeft::at(double fraction, double wall) const
  {
    constexpr double least  = 0.01; // the first per cent tells too little to foretell the rest
    constexpr double nobody = std::numeric_limits<double>::quiet_NaN();
    if (!(fraction > least) || fraction > 1. || stage_ >= expected_.size())
      return {nobody, nobody};
    const double in_stage = wall - start_, left = in_stage * (1. - fraction) / fraction;
    double       later = 0;
    for (std::size_t s = stage_ + 1; s < expected_.size(); ++s)
      {
        if (!(expected_[s] > 0))
          return {left, nobody};
        later += expected_[s];
      }
    if (later == 0)
      return {left, left};
    const double foreseen = done_ + expected_[stage_] * fraction;
    return {left, foreseen > 0 ? left + later * (spent_ + in_stage) / foreseen : nobody};
  }
} // namespace whipple
