// SPDX-License-Identifier: LGPL-2.1-or-later
#pragma once

#include <whipple/mesh/index.h>

#include <array>
#include <numbers>

/// Exact integrals over straight-edged quadrilaterals, planar (per cm of depth) or swept about axis 1
/// (r = axis 0, 2 pi included). Corners are lexicographic: 0 (-,-), 1 (+,-), 2 (-,+), 3 (+,+).
/// Equations: doc/theory/geometry.md.
namespace whipple::geometry
{
  /// Coordinates of the four corners, [axis][corner]. Number is double or a pack of doubles, one cell a lane.
  template <typename Number>
  using QuadOf = std::array<std::array<Number, 4>, 2>;

  using Quad = QuadOf<double>;

  /// Corner order of the counter-clockwise walk around a lexicographic quadrilateral.
  inline constexpr std::array<int, 4> walk{{0, 1, 3, 2}};

  /// Signed measure under one edge a -> b (Green): planar (x_a + x_b)/2 (y_b - y_a),
  /// axisymmetric 2 pi (r_a^2 + r_a r_b + r_b^2)/6 (z_b - z_a). Summed counter-clockwise it is the volume.
  template <Symmetry symmetry, typename Number = double>
  inline Number
  edge_volume(Number ra, Number za, Number rb, Number zb)
  {
    if constexpr (symmetry == Symmetry::planar)
      return 0.5 * (ra + rb) * (zb - za);
    else
      return (std::numbers::pi / 3.) * (ra * ra + ra * rb + rb * rb) * (zb - za);
  }

  /// Volume of the quadrilateral (of revolution).
  template <Symmetry symmetry, typename Number = double>
  inline Number
  volume(const QuadOf<Number> &x)
  {
    Number sum = 0;
    for (int i = 0; i < 4; ++i)
      {
        const int a = walk[i], b = walk[(i + 1) % 4];
        sum += edge_volume<symmetry>(x[0][a], x[1][a], x[0][b], x[1][b]);
      }
    return sum;
  }

  inline double
  volume(Symmetry symmetry, const Quad &x)
  {
    return symmetry == Symmetry::planar ? volume<Symmetry::planar>(x) : volume<Symmetry::axisymmetric>(x);
  }

  /// dV/dx of every corner: the corner vectors B_k on which a pressure works, [axis][corner].
  template <Symmetry symmetry, typename Number = double>
  inline QuadOf<Number>
  volume_gradient(const QuadOf<Number> &x)
  {
    QuadOf<Number> gradient{};
    for (int i = 0; i < 4; ++i)
      {
        const int    a = walk[i], b = walk[(i + 1) % 4];
        const Number ra = x[0][a], rb = x[0][b], dz = x[1][b] - x[1][a];
        if constexpr (symmetry == Symmetry::planar)
          {
            gradient[0][a] += 0.5 * dz;
            gradient[0][b] += 0.5 * dz;
            gradient[1][a] -= 0.5 * (ra + rb);
            gradient[1][b] += 0.5 * (ra + rb);
          }
        else
          {
            constexpr double third = std::numbers::pi / 3.;
            const Number     w     = third * (ra * ra + ra * rb + rb * rb);
            gradient[0][a] += third * (2. * ra + rb) * dz;
            gradient[0][b] += third * (ra + 2. * rb) * dz;
            gradient[1][a] -= w;
            gradient[1][b] += w;
          }
      }
    return gradient;
  }

  /// Jacobian of the bilinear map from the unit square at each corner (twice the corner triangle's area);
  /// all four positive = the element is convex.
  template <typename Number = double>
  inline std::array<Number, 4>
  corner_jacobian(const QuadOf<Number> &x)
  {
    std::array<Number, 4> jacobian;
    for (int k = 0; k < 4; ++k)
      {
        const int i = k ^ 1, j = k ^ 2, row = k & 2, column = k & 1;
        // d x / d xi along the row of corner k, d x / d eta along its column
        const double sx = column ? -1. : 1., sy = row ? -1. : 1.;
        jacobian[k] = sx * sy * ((x[0][i] - x[0][k]) * (x[1][j] - x[1][k]) - (x[1][i] - x[1][k]) * (x[0][j] - x[0][k]));
      }
    return jacobian;
  }

  /// Integral of shape function N_k over the plane area (no radius), times 2 pi in axisymmetry:
  /// the weights h_k of the hoop rate, D_hoop = sum_k h_k v_r,k / V. Zero in planar symmetry.
  template <Symmetry symmetry, typename Number = double>
  inline std::array<Number, 4>
  hoop_weight(const QuadOf<Number> &x)
  {
    std::array<Number, 4> h{};
    if constexpr (symmetry == Symmetry::axisymmetric)
      {
        const std::array<Number, 4> j = corner_jacobian(x);
        for (int k = 0; k < 4; ++k)
          h[k] = 2. * std::numbers::pi * (4. * j[k] + 2. * (j[k ^ 1] + j[k ^ 2]) + j[k ^ 3]) / 36.;
      }
    return h;
  }

  /// Integral of shape function N_k over the true volume: how a uniform density splits over the corners.
  /// Their sum is the volume. First cell at the axis: 1/6 inside, 1/3 outside.
  template <Symmetry symmetry>
  inline std::array<double, 4>
  corner_volume(const Quad &x)
  {
    const std::array<double, 4> j = corner_jacobian(x);
    std::array<double, 4>       w{};
    if constexpr (symmetry == Symmetry::planar)
      {
        for (int k = 0; k < 4; ++k)
          w[k] = (4. * j[k] + 2. * (j[k ^ 1] + j[k ^ 2]) + j[k ^ 3]) / 36.;
      }
    else
      {
        // integral of N_k N_a N_b over the unit square is a product of 1/4 (all equal) and 1/12 (one differs)
        const auto factor = [](int k, int a, int b, int bit) {
          return ((k ^ a) & bit) || ((k ^ b) & bit) ? 1. / 12. : 1. / 4.;
        };
        for (int k = 0; k < 4; ++k)
          for (int a = 0; a < 4; ++a)
            for (int b = 0; b < 4; ++b)
              w[k] += 2. * std::numbers::pi * factor(k, a, b, 1) * factor(k, a, b, 2) * x[0][a] * j[b];
      }
    return w;
  }
} // namespace whipple::geometry
