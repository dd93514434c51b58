// SPDX-License-Identifier: LGPL-2.1-or-later
#pragma once

#include <whipple/hydro/velocity_gradient.h>

/// Viscous resistance to the one nodal motion a quadrilateral with a single stress does not feel, after
/// [Flanagan1981].
/// Equations: doc/theory/lagrange_step.md, section "Hourglass".
namespace whipple::hourglass
{
  /// The alternating vector over lexicographic corners.
  inline constexpr std::array<double, 4> alternating{{1., -1., -1., 1.}};

  /// sum_k (-1)^k a_k
  template <typename Number>
  inline Number
  moment(const std::array<Number, 4> &a)
  {
    return (a[0] - a[1]) - (a[2] - a[3]);
  }

  /// Hourglass velocity along both axes, cm/us: gamma . v with gamma orthogonal to every velocity that is
  /// linear in position. @param shape moments of the corner positions, cm
  template <typename Number>
  inline std::array<Number, 2>
  velocity(const std::array<Number, 2> &shape, const VelocityGradient<2, Number> &gradient,
           const CornerVectors<2, Number> &v)
  {
    std::array<Number, 2> rate;
    for (int i = 0; i < 2; ++i)
      rate[i] = moment(v[i]) - (shape[0] * gradient.l[i][0] + shape[1] * gradient.l[i][1]);
    return rate;
  }

  /// gamma_k. @param g g_k = B_k - h_k e_r (shape_gradient())
  template <typename Number>
  inline Number
  shape_vector(int k, const std::array<Number, 2> &shape, const std::array<Number, 2> &g, const Number &inverse)
  {
    return alternating[k] - (shape[0] * g[0] + shape[1] * g[1]) * inverse;
  }
} // namespace whipple::hourglass
