// SPDX-License-Identifier: LGPL-2.1-or-later
#pragma once

#include <cstddef>
#include <span>
#include <utility>
#include <vector>

namespace whipple
{
  /// Slopes at the points (x, y) of a smooth function: the derivative of the polynomial through the five nearest
  /// points.
  /// @param x strictly ascending, at least two.
  std::vector<double>
  smooth_slopes(std::span<const double> x, std::span<const double> y);

  /// Slopes of a piecewise cubic that is monotone wherever the points are: smooth_slopes(), but 0 at an extremum and at
  /// most `limit` times the smaller of the two neighbouring secants. limit <= 3 keeps the cubic monotone
  /// [Fritsch1980]; limit <= 1.5 keeps its Bezier polygon monotone, too.
  /// @param x strictly ascending, at least two.
  std::vector<double>
  monotone_slopes(std::span<const double> x, std::span<const double> y, double limit);

  /// The interval [axis[i], axis[i + 1]) in which x lies; the first or the last one for x outside. The result does not
  /// depend on the hint, an index that is tried first.
  inline std::size_t
  find_interval(std::span<const double> axis, double x, std::size_t hint)
  {
    if (x >= axis[hint] && x < axis[hint + 1])
      return hint;
    std::size_t low = 0, high = axis.size() - 1;
    while (high - low > 1)
      {
        const std::size_t middle        = (low + high) / 2;
        (x < axis[middle] ? high : low) = middle;
      }
    return low;
  }

  /// Values and derivatives of the four cubic Hermite functions of an interval [a, b], at the point of it nearest to x.
  struct HermiteBasis
  {
    HermiteBasis(double a, double b, double x)
      : inside(x < a ? a : (x > b ? b : x))
    {
      const double h = b - a, inverse = 1. / h, s = (inside - a) * inverse, r = 1. - s;
      value[0]            = (1. + 2. * s) * r * r;
      value[1]            = (1. + 2. * r) * s * s;
      slope[0]            = h * s * r * r;
      slope[1]            = -h * s * s * r;
      value_derivative[0] = -6. * s * r * inverse;
      value_derivative[1] = 6. * s * r * inverse;
      slope_derivative[0] = r * (1. - 3. * s);
      slope_derivative[1] = s * (3. * s - 2.);
    }

    double inside;                                   ///< that point
    double value[2], slope[2];                       ///< of the values and slopes at both ends
    double value_derivative[2], slope_derivative[2]; ///< d/dx of them
  };

  /// The C1 piecewise cubic of given slopes at points, continued linearly beyond them.
  class PiecewiseCubic
  {
  public:
    PiecewiseCubic() = default;

    /// @param x strictly ascending, at least two.
    PiecewiseCubic(std::vector<double> x, std::vector<double> y, std::vector<double> slope)
      : x_(std::move(x))
      , y_(std::move(y))
      , slope_(std::move(slope))
    {
    }

    struct Point
    {
      double value, slope;
    };

    Point
    at(double x) const
    {
      return at(x, find_interval(x_, x, 0));
    }

    /// The same where the interval is known.
    Point
    at(double x, std::size_t i) const
    {
      const HermiteBasis b(x_[i], x_[i + 1], x);
      const double       slope = b.value_derivative[0] * y_[i] + b.value_derivative[1] * y_[i + 1] +
                           b.slope_derivative[0] * slope_[i] + b.slope_derivative[1] * slope_[i + 1];
      return {b.value[0] * y_[i] + b.value[1] * y_[i + 1] + b.slope[0] * slope_[i] + b.slope[1] * slope_[i + 1] +
                  (x - b.inside) * slope,
              slope};
    }

  private:
    std::vector<double> x_, y_, slope_;
  };
} // namespace whipple
