// SPDX-License-Identifier: LGPL-2.1-or-later
#pragma once

#include <gtest/gtest.h>

#include <algorithm>
#include <cctype>
#include <cmath>
#include <cstdio>
#include <string>

namespace whipple::figure
{
  /// Enter a measured figure into the table of doc/verification.md (scripts/verification_page.py reads it from the
  /// test program's JSON output).
  /// @param what     what is measured, unit included
  /// @param required what must hold, as text
  inline void
  record(const std::string &what, double reached, const std::string &required)
  {
    std::string key = "figure_";
    for (const char c : what)
      key += std::isalnum(static_cast<unsigned char>(c)) ? c : '_';
    char text[32];
    std::snprintf(text, sizeof text, "%.4g", reached);
    testing::Test::RecordProperty(key, what + " | " + required + " | " + text);
  }

  /// The largest of many values, recorded when it goes out of scope.
  class Largest
  {
  public:
    Largest(const std::string &what, const std::string &required)
      : what_(what)
      , required_(required)
    {
    }
    ~Largest()
    {
      record(what_, value_, required_);
    }
    Largest(const Largest &) = delete;
    Largest &
    operator=(const Largest &) = delete;

    void
    operator()(double value)
    {
      value_ = std::max(value_, std::abs(value));
    }

  private:
    std::string what_, required_;
    double      value_ = 0;
  };

  /// Expect and record |value| <= bound.
  inline void
  expect_at_most(const std::string &what, double value, double bound)
  {
    char text[32];
    std::snprintf(text, sizeof text, "<= %.4g", bound);
    record(what, std::abs(value), text);
    EXPECT_LE(std::abs(value), bound) << what;
  }

  /// Expect value / reference within tolerance of 1 and record the deviation.
  inline void
  expect_relative(const std::string &what, double value, double reference, double tolerance)
  {
    char text[64];
    std::snprintf(text, sizeof text, "within %.4g %% of %.6g", 100. * tolerance, reference);
    record(what, value, text);
    EXPECT_NEAR(value / reference, 1., tolerance) << what << ": " << value << " for " << reference;
  }
} // namespace whipple::figure
