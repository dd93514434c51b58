// SPDX-License-Identifier: LGPL-2.1-or-later
#include <whipple/run/time_step_history.h>

#include <algorithm>
#include <cstdio>

namespace whipple
{
  namespace
  {
    constexpr double      below_median = 1e-4;
    constexpr double      below_first  = 1e-6;
    constexpr std::size_t first_steps  = 10; // the very first may be odd

    double
    largest(const std::vector<double> &steps, std::size_t begin, std::size_t end)
    {
      return *std::max_element(steps.begin() + begin, steps.begin() + end);
    }

    double
    median(std::vector<double> steps)
    {
      const auto middle = steps.begin() + steps.size() / 2;
      std::nth_element(steps.begin(), middle, steps.end());
      return *middle;
    }

    std::string
    describe(double now, const char *of, double then, std::size_t steps)
    {
      char text[160];
      std::snprintf(text, sizeof text, "the time step has collapsed to %.3g us, %.1e of %s (%.3g us), for %zu steps",
                    now, now / then, of, then, steps);
      return text;
    }
  } // namespace

  void
  TimeStepHistory::add(double dt)
  {
    steps_.push_back(dt);
  }

  std::optional<std::string>
  TimeStepHistory::collapse() const
  {
    if (steps_.size() < window + first_steps || steps_.size() % window != 0)
      return std::nullopt;
    const std::size_t before = steps_.size() - window;
    const double      now    = largest(steps_, before, steps_.size());
    const double      first  = largest(steps_, 0, first_steps);
    if (now < below_first * first)
      return describe(now, "its first steps", first, window);
    const double usual = median({steps_.begin(), steps_.begin() + before});
    if (now < below_median * usual)
      return describe(now, "the stage's median", usual, window);
    return std::nullopt;
  }

  double
  TimeStepHistory::typical()
  {
    const std::size_t full = steps_.size() / window * window;
    if (full != asked_at_)
      {
        asked_at_ = full;
        typical_ =
            full == 0 ? 0. : std::max(median({steps_.begin(), steps_.begin() + full}), largest(steps_, 0, first_steps));
      }
    return typical_;
  }
} // namespace whipple
