// SPDX-License-Identifier: LGPL-2.1-or-later
#include <whipple/scene/stage_end.h>

#include <algorithm>

namespace whipple
{
  namespace
  {
    double
    read_time(const StageEndInput &input)
    {
      const double time = input.value(input.rest, units::time);
      if (!(time > 0))
        input.reject("must be > 0 us");
      return time;
    }

    StageEnd::Left
    left_until(double end, double now)
    {
      const double left = end - now;
      return {left > 1e-9 * end ? left : 0., end}; // what is less is the round-off of a sum of steps
    }

    /// At a time since the start of the run.
    class EndAtTime : public StageEnd
    {
    public:
      explicit EndAtTime(double time)
        : time_(time)
      {
      }
      double
      expected(const StageOutlook &outlook) const override
      {
        return std::max(outlook.start, time_);
      }
      std::optional<double>
      fixed_time() const override
      {
        return time_;
      }
      bool
      is_known() const override
      {
        return true;
      }
      Left
      time_left(const StageView &stage, std::vector<double> &) const override
      {
        return left_until(time_, stage.time());
      }

    private:
      double time_; ///< us
    };

    /// A time after the start of the stage.
    class EndAfter : public StageEnd
    {
    public:
      explicit EndAfter(double duration)
        : duration_(duration)
      {
      }
      double
      expected(const StageOutlook &outlook) const override
      {
        return outlook.start + duration_;
      }
      bool
      is_known() const override
      {
        return true;
      }
      Left
      time_left(const StageView &stage, std::vector<double> &) const override
      {
        return left_until(stage.start() + duration_, stage.time());
      }

    private:
      double duration_; ///< us
    };

    const StageEndRegistration
        at_time("", {"a time such as '1.5 us'", "that time since the start of the run",
                     [](const StageEndInput &input) { return std::make_shared<EndAtTime>(read_time(input)); }});
    const StageEndRegistration
        after("for", {"'for 2 us'", "that long after the start of the stage",
                      [](const StageEndInput &input) { return std::make_shared<EndAfter>(read_time(input)); }});
  } // namespace
} // namespace whipple
