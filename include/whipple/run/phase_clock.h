// SPDX-License-Identifier: LGPL-2.1-or-later
#pragma once

#include <chrono>
#include <map>
#include <string>
#include <string_view>
#include <vector>

namespace whipple
{
  /// What a run spends its time on: wall seconds of this rank by phase, always counted. A phase within another counts
  /// for itself alone. (deal.II's TimerOutput asks the system for processor times at each change, and may synchronise
  /// the ranks; a debris stage has steps of 20 us. Here a change takes some 0.1 us.)
  class PhaseClock
  {
  public:
    /// A phase, for as long as it lives.
    class Scope
    {
    public:
      explicit Scope(PhaseClock *clock)
        : clock_(clock)
      {
      }
      Scope(const Scope &) = delete;
      Scope &
      operator=(const Scope &) = delete;
      ~Scope()
      {
        if (clock_)
          clock_->leave();
      }

    private:
      PhaseClock *clock_; ///< null: counts as the phase around it
    };

    /// @param name a literal
    [[nodiscard]] Scope
    phase(std::string_view name)
    {
      return enter(name, false);
    }

    /// A phase that counts with all that happens meanwhile.
    [[nodiscard]] Scope
    phase_with_all(std::string_view name)
    {
      return enter(name, true);
    }

    /// Seconds of each phase that has ended or been interrupted.
    std::map<std::string, double>
    seconds() const
    {
      return {seconds_.begin(), seconds_.end()};
    }

  private:
    using Clock = std::chrono::steady_clock;

    struct Open
    {
      double *seconds;
      bool    with_all;
    };

    Scope
    enter(std::string_view name, bool with_all)
    {
      if (!open_.empty() && open_.back().with_all)
        return Scope(nullptr);
      count();
      open_.push_back({&seconds_[name], with_all});
      return Scope(this);
    }

    void
    leave()
    {
      count();
      open_.pop_back();
    }

    /// Give the time since the last change to the phase that it was spent in.
    void
    count()
    {
      const Clock::time_point now = Clock::now();
      if (!open_.empty())
        *open_.back().seconds += std::chrono::duration<double>(now - last_).count();
      last_ = now;
    }

    std::map<std::string_view, double> seconds_;
    std::vector<Open>                  open_;
    Clock::time_point                  last_;
  };
} // namespace whipple
