// SPDX-License-Identifier: LGPL-2.1-or-later
#pragma once

#include <whipple/study/analysis.h>
#include <whipple/study/study_plan.h>

#include <string>

namespace whipple
{
  /// How far from its limit a quantity may be.
  struct Tolerance
  {
    std::string text;             ///< as given, "bumper hole diameter = 2 %"
    Quantity    quantity;         ///< what it is about
    double      amount   = 0;     ///< in the quantity's unit, or a part of its value
    bool        relative = false; ///< `amount` is a part of the value
  };

  /// Read "NAME = AMOUNT": AMOUNT in % or with a unit; NAME any words that fit one result of the study's runs
  /// ("bumper hole diameter" is bumper/hole_diameter_cm), or a field of the exact solution, "density" or "density L2".
  /// @throws InputError one line that lists what there is if nothing fits, or what fits if it is more than one.
  Tolerance
  read_tolerance(const std::string &text, const StudyPlan &plan);

  /// Seconds in "20 min", "90 s", "1.5 h". @throws InputError
  double
  read_budget(const std::string &text);
} // namespace whipple
