// SPDX-License-Identifier: LGPL-2.1-or-later
#pragma once

#include <cstddef>
#include <vector>

namespace whipple
{
  /// A function of one number from its values at equidistant nodes: cubic Hermite polynomials whose slopes at the nodes
  /// are differences of fourth order, so continuously differentiable and exact for cubics; straight beyond the ends.
  class HermiteTable
  {
  public:
    struct Value
    {
      double value, slope;
    };

    HermiteTable() = default;

    /// @param values at first, first + step, ...; at least 5.
    HermiteTable(double first, double step, std::vector<double> values);

    double
    first() const
    {
      return first_;
    }
    double
    last() const
    {
      return first_ + step_ * static_cast<double>(nodes_.size() - 1);
    }

    /// The function and the exact derivative of what it returns.
    Value
    operator()(double x) const
    {
      const double position = (x - first_) / step_;
      const double end      = static_cast<double>(nodes_.size() - 1);
      if (!(position > 0.)) // not-a-number goes through
        return {nodes_.front().value + nodes_.front().slope * (x - first_), nodes_.front().slope};
      if (position >= end)
        return {nodes_.back().value + nodes_.back().slope * (x - last()), nodes_.back().slope};
      const std::size_t i = static_cast<std::size_t>(position);
      const double      t = position - static_cast<double>(i), u = 1. - t;
      const Value      &a = nodes_[i], &b = nodes_[i + 1];
      const double      rise = b.value - a.value;
      return {a.value + t * t * (3. - 2. * t) * rise + step_ * t * u * (u * a.slope - t * b.slope),
              6. * t * u * rise / step_ + u * (1. - 3. * t) * a.slope + t * (3. * t - 2.) * b.slope};
    }

  private:
    double             first_ = 0., step_ = 1.;
    std::vector<Value> nodes_;
  };
} // namespace whipple
