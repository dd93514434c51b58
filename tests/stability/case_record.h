// SPDX-License-Identifier: LGPL-2.1-or-later
#pragma once

#include <gtest/gtest.h>

#include <chrono>
#include <cmath>
#include <cstdio>
#include <string>
#include <vector>

namespace whipple::stability
{
  /// A case of the suite: what it is, what would go wrong, and for each thing that must hold the bound and the figure
  /// reached. Becomes rows of doc/stability.md (scripts/stability_page.py reads them from the test program's JSON
  /// output) when it goes out of scope.
  class Case
  {
  public:
    /// @param name  of the case
    /// @param wrong what would go wrong
    /// @param mode  "eulerian", "lagrangian", or the chain of stages
    Case(const std::string &name, const std::string &wrong, const std::string &mode)
      : name_(name)
      , wrong_(wrong)
      , mode_(mode)
      , start_(std::chrono::steady_clock::now())
    {
    }
    Case(const Case &) = delete;
    Case &
    operator=(const Case &) = delete;
    ~Case()
    {
      const double seconds = std::chrono::duration<double>(std::chrono::steady_clock::now() - start_).count();
      char         text[32];
      std::snprintf(text, sizeof text, "%.1f", seconds);
      for (const Row &row : rows_)
        {
          static int number = 0;
          char       key[32];
          std::snprintf(key, sizeof key, "stability_%04d", number++);
          testing::Test::RecordProperty(key, name_ + " | " + wrong_ + " | " + row.bound + " | " + row.figure + " | " +
                                                 mode_ + " | " + text + " | " + row.verdict);
        }
    }

    /// value <= bound must hold (not a number does not).
    void
    at_most(const std::string &what, double value, double bound)
    {
      check(what + " <= " + digits(bound), digits(value), value <= bound);
    }

    /// value >= bound must hold.
    void
    at_least(const std::string &what, double value, double bound)
    {
      check(what + " >= " + digits(bound), digits(value), value >= bound);
    }

    /// value > bound must hold.
    void
    above(const std::string &what, double value, double bound)
    {
      check(what + " > " + digits(bound), digits(value), value > bound);
    }

    /// value must lie within a part of the reference.
    void
    within(const std::string &what, double value, double reference, double part)
    {
      check(what + " within " + digits(100. * part) + " % of " + digits(reference), digits(value),
            std::abs(value - reference) <= part * std::abs(reference));
    }

    /// value <= bound is the goal; it is not reached (doc/limitations.md or doc/open_faults.md say why), and the test
    /// stands at an honest value.
    void
    at_most_short(const std::string &what, double value, double bound, double honest)
    {
      fall_short(what + " <= " + digits(bound), value, value <= bound, value <= honest, honest);
    }

    /// The same for a part of the reference.
    void
    within_short(const std::string &what, double value, double reference, double part, double honest)
    {
      const double miss = std::abs(value - reference) / std::abs(reference);
      fall_short(what + " within " + digits(100. * part) + " % of " + digits(reference), value, miss <= part,
                 miss <= honest, honest);
    }

    /// Something that holds or not.
    void
    holds(const std::string &what, bool does, const std::string &figure)
    {
      check(what, figure, does);
    }

    /// A figure that is reported without a bound.
    void
    report(const std::string &what, double value)
    {
      rows_.push_back({what + ": reported", digits(value), "holds"});
    }

    const std::string &
    name() const
    {
      return name_;
    }

  private:
    struct Row
    {
      std::string bound, figure, verdict;
    };

    static std::string
    digits(double value)
    {
      char text[32];
      std::snprintf(text, sizeof text, "%.4g", value);
      return text;
    }

    void
    check(const std::string &bound, const std::string &figure, bool does)
    {
      rows_.push_back({bound, figure, does ? "holds" : "FAILS"});
      EXPECT_TRUE(does) << name_ << " (" << mode_ << "): " << bound << ": " << figure;
    }

    void
    fall_short(const std::string &bound, double value, bool reached, bool honest, double at)
    {
      rows_.push_back({bound, digits(value), reached ? "holds" : honest ? "short" : "FAILS"});
      EXPECT_TRUE(honest) << name_ << " (" << mode_ << "): " << bound << ", short of it, allowed " << at << ": "
                          << digits(value);
    }

    std::string                           name_, wrong_, mode_;
    std::chrono::steady_clock::time_point start_;
    std::vector<Row>                      rows_;
  };
} // namespace whipple::stability
