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
                                                 mode_ + " | " + text + " | " + (row.holds ? "holds" : "FAILS"));
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
      rows_.push_back({what + ": reported", digits(value), true});
    }

    const std::string &
    name() const
    {
      return name_;
    }

  private:
    struct Row
    {
      std::string bound, figure;
      bool        holds;
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
      rows_.push_back({bound, figure, does});
      EXPECT_TRUE(does) << name_ << " (" << mode_ << "): " << bound << ": " << figure;
    }

    std::string                           name_, wrong_, mode_;
    std::chrono::steady_clock::time_point start_;
    std::vector<Row>                      rows_;
  };
} // namespace whipple::stability
