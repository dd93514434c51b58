// SPDX-License-Identifier: LGPL-2.1-or-later
#pragma once

#include <whipple/exact/exact_solution.h>
#include <whipple/scene/expression.h>
#include <whipple/scene/shape.h>

#include <array>
#include <optional>
#include <string>

namespace whipple
{
  /// The state a body enters with, as expressions of its coordinates; what has none is uniform. It is a solution that
  /// has material in the body only, so that cells receive means over their part of the body, as from an exact one.
  template <int dim>
  class ExpressionState : public exact::ExactSolution<dim>
  {
  public:
    struct Parts
    {
      std::optional<Expression>                  density;  ///< g/cm^3
      std::optional<Expression>                  energy;   ///< Mbar cm^3/g
      std::optional<std::array<Expression, dim>> velocity; ///< cm/us
    };

    /// @param uniform what holds where there is no expression
    ExpressionState(const std::string &body, const Shape<dim> &shape, const exact::PointState<dim> &uniform,
                    Parts parts);

    /// Outside of the body the density is 0; all else is what the expressions say there, if it is a number.
    /// @throws StateError naming the body and the point where the density in it is not > 0, or anything not finite
    exact::PointState<dim>
    at(const Vector<dim> &x, double time) const override;

    /// What the expressions say at a point, in the body or not.
    exact::PointState<dim>
    value(const Vector<dim> &x) const;

    /// What is wrong with a state in the body ("density = -1 g/cm^3"); empty if nothing is.
    static std::string
    problem(const exact::PointState<dim> &state);

  private:
    Shape<dim>             shape_;
    exact::PointState<dim> uniform_;
    Parts                  parts_;
  };
} // namespace whipple
