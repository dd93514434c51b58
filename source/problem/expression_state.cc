// SPDX-License-Identifier: LGPL-2.1-or-later
#include <whipple/error.h>
#include <whipple/problem/expression_state.h>

#include <cmath>
#include <sstream>
#include <utility>

namespace whipple
{
  template <int dim>
  ExpressionState<dim>::ExpressionState(const std::string &body, const Shape<dim> &shape,
                                        const exact::PointState<dim> &uniform, Parts parts)
    : exact::ExactSolution<dim>("expressions of body '" + body + "'")
    , shape_(shape)
    , uniform_(uniform)
    , parts_(std::move(parts))
  {
  }

  template <int dim>
  exact::PointState<dim>
  ExpressionState<dim>::value(const Vector<dim> &x) const
  {
    exact::PointState<dim> state = uniform_;
    if (parts_.density)
      state.density = (*parts_.density)(x);
    if (parts_.energy)
      state.energy = (*parts_.energy)(x);
    if (parts_.velocity)
      for (int d = 0; d < dim; ++d)
        state.velocity[d] = (*parts_.velocity)[d](x);
    return state;
  }

  template <int dim>
  std::string
  ExpressionState<dim>::problem(const exact::PointState<dim> &state)
  {
    const auto shown = [](double value, const char *unit) {
      std::ostringstream text;
      text << value << ' ' << unit;
      return std::isnan(value) ? "not a number" : text.str();
    };
    if (!(state.density > 0) || !std::isfinite(state.density))
      return "the density is " + shown(state.density, "g/cm^3");
    if (!std::isfinite(state.energy))
      return "the specific energy is " + shown(state.energy, "Mbar cm^3/g");
    for (int d = 0; d < dim; ++d)
      if (!std::isfinite(state.velocity[d]))
        return "the velocity along axis " + std::to_string(d) + " is " + shown(state.velocity[d], "cm/us");
    return "";
  }

  template <int dim>
  exact::PointState<dim>
  ExpressionState<dim>::at(const Vector<dim> &x, double) const
  {
    exact::PointState<dim> state = value(x);
    if (!shape_->contains(x))
      {
        state.density = 0;
        for (double &v : state.velocity)
          v = std::isfinite(v) ? v : exact::not_given;
      }
    else if (const std::string wrong = problem(state); !wrong.empty())
      {
        std::ostringstream text;
        text << this->name() << ": " << wrong << " at (" << x[0] << ", " << x[1] << ") cm";
        throw StateError(text.str());
      }
    return state;
  }

  template class ExpressionState<2>;
} // namespace whipple
