// SPDX-License-Identifier: LGPL-2.1-or-later
#pragma once

#include <whipple/material/piecewise_cubic.h>

#include <array>
#include <optional>

namespace whipple
{
  /// A function of x and y given on a grid: bicubic Hermite interpolation with continuous first derivatives, monotone
  /// along every grid line where the data are. Beyond the grid it is continued linearly in the direction that leaves
  /// it, C1 as well (doc/theory/equation_of_state_tables.md).
  class BicubicTable
  {
  public:
    /// @param x, y strictly ascending, at least two each
    /// @param values of (x_i, y_j) at [i * y.size() + j], finite
    BicubicTable(std::vector<double> x, std::vector<double> y, const std::vector<double> &values);

    struct Point
    {
      double value, dx, dy;
    };

    /// Intervals of x and y.
    struct Cell
    {
      std::size_t i = 0, j = 0;
    };

    /// @param hint cell that is tried first, and the one found; the result does not depend on it.
    Point
    at(double x, double y, Cell &hint) const;

    /// Of the y at which the function has a value at this x, the one nearest to `near`; none if there is none. Where
    /// the function turns between two grid lines of y and comes back before the second, both y are overlooked.
    std::optional<double>
    find_y(double x, double value, double near) const;

    const std::vector<double> &
    x() const
    {
      return x_;
    }
    const std::vector<double> &
    y() const
    {
      return y_;
    }

  private:
    /// f, f_x, f_y and f_xy at a node.
    struct Node
    {
      double f, fx, fy, fxy;
    };

    const Node &
    node(std::size_t i, std::size_t j) const
    {
      return nodes_[i * y_.size() + j];
    }

    /// The y in the interval j at which the function has a value at this x that lies between those at its ends.
    double
    find_y_within(double x, double value, std::size_t j) const;

    std::vector<double> x_, y_;
    std::vector<Node>   nodes_;
  };

  inline BicubicTable::Point
  BicubicTable::at(double x, double y, Cell &hint) const
  {
    const std::size_t  i = hint.i = find_interval(x_, x, hint.i);
    const std::size_t  j = hint.j = find_interval(y_, y, hint.j);
    const HermiteBasis bx(x_[i], x_[i + 1], x), by(y_[j], y_[j + 1], y);

    // along y on both grid lines: f, f_x and their derivatives in y
    double f[2], fx[2], fy[2], fxy[2];
    for (int side = 0; side < 2; ++side)
      {
        const Node &a = node(i + side, j), &b = node(i + side, j + 1);
        f[side]  = by.value[0] * a.f + by.value[1] * b.f + by.slope[0] * a.fy + by.slope[1] * b.fy;
        fx[side] = by.value[0] * a.fx + by.value[1] * b.fx + by.slope[0] * a.fxy + by.slope[1] * b.fxy;
        fy[side] = by.value_derivative[0] * a.f + by.value_derivative[1] * b.f + by.slope_derivative[0] * a.fy +
                   by.slope_derivative[1] * b.fy;
        fxy[side] = by.value_derivative[0] * a.fx + by.value_derivative[1] * b.fx + by.slope_derivative[0] * a.fxy +
                    by.slope_derivative[1] * b.fxy;
      }
    const double value = bx.value[0] * f[0] + bx.value[1] * f[1] + bx.slope[0] * fx[0] + bx.slope[1] * fx[1];
    const double dx = bx.value_derivative[0] * f[0] + bx.value_derivative[1] * f[1] + bx.slope_derivative[0] * fx[0] +
                      bx.slope_derivative[1] * fx[1];
    const double dy  = bx.value[0] * fy[0] + bx.value[1] * fy[1] + bx.slope[0] * fxy[0] + bx.slope[1] * fxy[1];
    const double dxy = bx.value_derivative[0] * fy[0] + bx.value_derivative[1] * fy[1] +
                       bx.slope_derivative[0] * fxy[0] + bx.slope_derivative[1] * fxy[1];

    const double over_x = x - bx.inside, over_y = y - by.inside; // 0 in the table
    return {value + over_x * dx + over_y * (dy + over_x * dxy), dx + over_y * dxy, dy + over_x * dxy};
  }
} // namespace whipple
