// SPDX-License-Identifier: LGPL-2.1-or-later
#pragma once

#include <optional>
#include <string>
#include <vector>

/// What a sequence of results on finer and finer cells says about the limit: observed order, Richardson extrapolation,
/// grid convergence index. Pure functions of numbers.
///
/// Sources: [Roache1994]; [Celik2008]; [Eca2014] (safety factor 3 where no order can be trusted).
namespace whipple::convergence
{
  /// The scheme's formal order: no error bar counts on a faster decrease.
  inline constexpr double formal_order = 2;
  /// No error bar counts on a slower decrease either; an observed order below this is reported as it is.
  inline constexpr double least_order = 0.5;
  /// Roache's safety factor with three levels, and where the order is a guess or there is none.
  inline constexpr double safety = 1.25, cautious_safety = 3;

  /// A quantity at a cell size.
  struct Level
  {
    double cell;  ///< cm
    double value; ///< result or error
  };

  /// What the finest levels do.
  enum class Verdict
  {
    one_level,   ///< nothing can be said
    two_levels,  ///< a difference, no order
    monotone,    ///< differences of one sign that shrink
    unchanging,  ///< the finest two are equal
    oscillating, ///< differences of changing sign
    diverging    ///< differences of one sign that do not shrink
  };

  /// One word or two for tables.
  std::string
  name(Verdict verdict);

  /// What a sequence of values says.
  struct Estimate
  {
    Verdict               verdict = Verdict::one_level;
    double                finest  = 0;  ///< value on the finest cells
    std::optional<double> order;        ///< observed, of the finest three levels
    std::optional<double> extrapolated; ///< Richardson's limit (monotone sequences)
    std::optional<double> error_bar;    ///< absolute, of the finest value; none with one level

    /// The extrapolated value, or the finest where there is none.
    double
    limit() const
    {
      return extrapolated.value_or(finest);
    }
    /// What limit() itself may be wrong by: the error bar but for the distance of the finest value from it.
    double
    limit_uncertainty() const;
  };

  /// Order p at which errors of an exact solution decrease from one level to the next finer one:
  /// ln(E_coarse / E_fine) / ln(h_coarse / h_fine); none if an error is not > 0.
  std::optional<double>
  order_of_errors(const Level &coarse, const Level &fine);

  /// Observed order of three values f3, f2, f1 on cells h3 > h2 > h1: the p that solves
  /// (f3 - f2) / (f2 - f1) = (r32^p - 1) / (1 - r21^-p), r21 = h2 / h1, r32 = h3 / h2
  /// (that is f = f0 + C h^p; for equal ratios p = ln((f3 - f2) / (f2 - f1)) / ln r). None unless both differences have
  /// one sign. Negative if the differences grow: the sequence moves away.
  std::optional<double>
  order_of_values(const Level &coarse, const Level &medium, const Level &fine);

  /// Judge a sequence by its finest three levels. `levels` in any order, cell sizes distinct, at least one.
  ///
  /// The error bar of the finest value, with p kept in [least_order, formal_order]:
  /// - monotone: safety * max(|f2 - f1| / (r21^p - 1), |f3 - f1| / (r31^2 - 1)), Roache's index; the second part keeps
  ///   a lucky small last difference from promising too much
  /// - unchanging: safety * |f3 - f1| / (r31 - 1), order 1 assumed
  /// - oscillating: cautious_safety * half the range of the three values
  /// - diverging: cautious_safety * their range
  /// - two levels: cautious_safety * |f2 - f1| / (r21 - 1), order 1 assumed
  Estimate
  estimate(std::vector<Level> levels);

  /// C h^p through levels by least squares of the logarithms.
  struct PowerLaw
  {
    double factor = 0, exponent = 0;

    double
    operator()(double cell) const;
  };

  /// @throws Error with fewer than two levels or values that are not > 0.
  PowerLaw
  fit_power_law(const std::vector<Level> &levels);
} // namespace whipple::convergence
