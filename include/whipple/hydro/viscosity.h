// SPDX-License-Identifier: LGPL-2.1-or-later
#pragma once

#include <whipple/hydro/hydro_parameters.h>
#include <whipple/hydro/pack.h>
#include <whipple/mesh/cell_geometry.h>

#include <array>

/// Scalar artificial viscosity, limited along the two logical directions of a cell.
/// Equations: doc/theory/lagrange_step.md, section "Artificial viscosity".
namespace whipple::viscosity
{
  /// Slower compression, 1/us, is none: its inverse would overflow.
  inline constexpr double smallest_rate = 1e-100;

  /// Vector of the cell along a logical axis, between the middles of its two opposite sides, and the same
  /// combination of any corner values.
  template <typename Number>
  inline Number
  along(int axis, const std::array<Number, 4> &a)
  {
    return axis == 0 ? Number(0.5 * ((a[1] - a[0]) + (a[3] - a[2]))) : Number(0.5 * ((a[2] - a[0]) + (a[3] - a[1])));
  }

  /// One logical direction of a cell.
  template <typename Number>
  struct Stretch
  {
    Number length; ///< cm
    Number rate;   ///< rate of stretch, 1/us; negative in compression
  };

  /// Stretch along `axis` of a cell with corners x, cm, and corner velocities v, cm/us.
  template <typename Number>
  inline Stretch<Number>
  stretch(int axis, const CornerVectors<2, Number> &x, const CornerVectors<2, Number> &v)
  {
    using std::sqrt;
    const Number e0 = along(axis, x[0]), e1 = along(axis, x[1]);
    const Number square = e0 * e0 + e1 * e1;
    return {sqrt(square), (e0 * along(axis, v[0]) + e1 * along(axis, v[1])) / square};
  }

  /// Share of the compression that the neighbours continue, 0 (shock) to 1 (uniform).
  /// @param rate negative   @param lower, upper rates of the neighbours across the two sides
  template <typename Number>
  inline Number
  limiter(const Number &rate, const Number &lower, const Number &upper)
  {
    using std::max;
    using std::min;
    const Number inverse = 1. / rate, below = lower * inverse, above = upper * inverse;
    const Number psi = min(Number(0.5 * (below + above)), min(Number(2. * below), Number(2. * above)));
    return max(Number(0.), min(Number(1.), psi));
  }

  /// Velocity jump across the thin direction of a cell, cm/us: the rate at which its plane area shrinks over its
  /// longest diagonal. In a rectangle never more than the sum of the jumps along its sides; in a rhombus that a shock
  /// along the diagonal has flattened those all but vanish, because its sides hardly shorten any more, and this one
  /// does not.
  template <typename Number>
  inline Number
  thin_jump(const CornerVectors<2, Number> &x, const CornerVectors<2, Number> &v)
  {
    using std::max;
    using std::sqrt;
    const Number x30 = x[0][3] - x[0][0], y30 = x[1][3] - x[1][0], x21 = x[0][2] - x[0][1], y21 = x[1][2] - x[1][1];
    const Number u30 = v[0][3] - v[0][0], w30 = v[1][3] - v[1][0], u21 = v[0][2] - v[0][1], w21 = v[1][2] - v[1][1];
    const Number shrinking = 0.5 * (y30 * u21 - x30 * w21 + w30 * x21 - u30 * y21);
    return max(Number(0.), shrinking) / sqrt(max(Number(x30 * x30 + y30 * y30), Number(x21 * x21 + y21 * y21)));
  }

  /// Velocity jumps of a cell summed over its compressed directions, cm/us.
  template <typename Number>
  struct Jumps
  {
    Number limited = 0.; ///< sum |du| (1 - psi)
    Number raised  = 0.; ///< sum |du| (1 + psi)

    /// Add one direction; nothing unless it is compressed. @param lower, upper rates of the neighbours
    void
    add(const Stretch<Number> &own, const Number &lower, const Number &upper)
    {
      const auto   compressed = own.rate < Number(-smallest_rate);
      const Number psi        = limiter(select(compressed, own.rate, Number(-1.)), lower, upper);
      const Number jump       = select(compressed, Number(-own.length * own.rate), Number(0.));
      limited += jump * (1. - psi);
      raised += jump * (1. + psi);
    }

    /// Scale the jumps so that sum |du| is `least` or more.
    void
    raise_to(const Number &least)
    {
      using std::max;
      const Number sum    = 0.5 * (limited + raised);
      const Number factor = select(sum > 0., max(Number(1.), Number(least / sum)), Number(1.));
      limited *= factor;
      raised *= factor;
    }

    /// q = rho sum |du| (1 - psi) [c2 sum |du| (1 + psi) + c1 c], Mbar.
    Number
    pressure(const HydroParameters &parameters, const Number &density, const Number &sound_speed) const
    {
      return density * limited * (parameters.quadratic_viscosity * raised + parameters.linear_viscosity * sound_speed);
    }
  };
} // namespace whipple::viscosity
