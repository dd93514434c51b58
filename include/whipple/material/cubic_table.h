// SPDX-License-Identifier: LGPL-2.1-or-later
#pragma once

#include <algorithm>
#include <vector>

namespace whipple
{
  /// A smooth function of one variable, kept as cubics between equally spaced nodes: value and slope of the function at
  /// every node, so continuous with its first derivative; the error falls with the fourth power of the spacing.
  /// Outside of [lower, upper] it keeps the value at the nearer end.
  class CubicTable
  {
  public:
    struct Node
    {
      double value, slope;
    };

    CubicTable() = default;

    /// @param nodes at lower, ..., upper, equally spaced; at least two, lower < upper (std::logic_error otherwise)
    CubicTable(double lower, double upper, const std::vector<Node> &nodes);

    /// Not-a-number is taken for `upper`: the caller's own arithmetic must carry it on.
    double
    operator()(double x) const
    {
      const double  inside   = std::max(lower_, std::min(upper_, x));
      const double  position = (inside - lower_) * per_interval_;
      const int     interval = std::min(static_cast<int>(position), intervals_ - 1);
      const double  f        = position - interval;
      const double *c        = coefficients_.data() + 4 * interval;
      return c[0] + f * (c[1] + f * (c[2] + f * c[3]));
    }

  private:
    double              lower_ = 0, upper_ = 0, per_interval_ = 0;
    int                 intervals_ = 0;
    std::vector<double> coefficients_; ///< four an interval, in powers of the position inside of it
  };
} // namespace whipple
