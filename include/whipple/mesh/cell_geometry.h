// SPDX-License-Identifier: LGPL-2.1-or-later
#pragma once

#include <whipple/mesh/index.h>

#include <algorithm>
#include <array>
#include <cmath>
#include <numbers>

/// The geometry of one cell: all that is known of its shape is here. Number is double or a pack of doubles, one cell a
/// lane. Only two dimensions exist; what a third one needs is a second set of these types (doc/dimensions.md).
/// Equations: doc/theory/geometry.md.
namespace whipple
{
  /// One number at each corner of a cell. Corners are lexicographic, bit d of k = upper along axis d: in a plane
  /// 0 (-,-), 1 (+,-), 2 (-,+), 3 (+,+).
  template <int dim, typename Number = double>
  using CornerValues = std::array<Number, (1 << dim)>;

  /// Coordinates, or another vector, at each corner of a cell, [axis][corner].
  template <int dim, typename Number = double>
  using CornerVectors = std::array<CornerValues<dim, Number>, static_cast<std::size_t>(dim)>;

  /// Scalar product of two vectors at corner k.
  template <std::size_t dim, std::size_t corners, typename Number>
  inline Number
  dot_at_corner(int k, const std::array<std::array<Number, corners>, dim> &a,
                const std::array<std::array<Number, corners>, dim> &b)
  {
    Number sum = a[0][k] * b[0][k];
    for (std::size_t d = 1; d < dim; ++d)
      sum += a[d][k] * b[d][k];
    return sum;
  }

  /// What the shape of a cell tells without regard to what the plane stands for.
  template <int dim>
  struct CellShape;

  /// Quadrilateral with straight sides.
  template <>
  struct CellShape<2>
  {
    static constexpr int corners = 4;

    /// Corner order of the counter-clockwise walk around a lexicographic quadrilateral.
    static constexpr std::array<int, 4> walk{{0, 1, 3, 2}};

    /// Corners of the box between two points.
    static CornerVectors<2>
    box(const Vector<2> &lower, const Vector<2> &upper)
    {
      return {{{{lower[0], upper[0], lower[0], upper[0]}}, {{lower[1], lower[1], upper[1], upper[1]}}}};
    }

    /// Mean of the corners.
    static Vector<2>
    middle(const CornerVectors<2> &x)
    {
      return {{0.25 * (x[0][0] + x[0][1] + x[0][2] + x[0][3]), 0.25 * (x[1][0] + x[1][1] + x[1][2] + x[1][3])}};
    }

    /// Area in the plane, cm^2; negative if it is turned over.
    template <typename Number>
    static Number
    area(const CornerVectors<2, Number> &x)
    {
      Number sum = 0;
      for (int i = 0; i < 4; ++i)
        {
          const int a = walk[i], b = walk[(i + 1) % 4];
          sum += 0.5 * (x[0][a] + x[0][b]) * (x[1][b] - x[1][a]);
        }
      return sum;
    }

    /// Smallest extent, cm: its area over its longest side or diagonal / sqrt(2).
    template <typename Number>
    static Number
    smallest_extent(const CornerVectors<2, Number> &x)
    {
      using std::max;
      using std::sqrt;
      const auto square = [&x](int a, int b) -> Number {
        const Number d0 = x[0][b] - x[0][a], d1 = x[1][b] - x[1][a];
        return d0 * d0 + d1 * d1;
      };
      const Number sides    = max(max(square(0, 1), square(2, 3)), max(square(0, 2), square(1, 3)));
      const Number diagonal = 0.5 * max(square(0, 3), square(1, 2));
      return area(x) / sqrt(max(sides, diagonal));
    }

    /// Jacobian of the bilinear map from the unit square at each corner (twice the corner triangle's area);
    /// all four positive = the element is convex.
    template <typename Number>
    static CornerValues<2, Number>
    corner_jacobian(const CornerVectors<2, Number> &x)
    {
      CornerValues<2, Number> jacobian;
      for (int k = 0; k < 4; ++k)
        {
          const int i = k ^ 1, j = k ^ 2, row = k & 2, column = k & 1;
          // d x / d xi along the row of corner k, d x / d eta along its column
          const double sx = column ? -1. : 1., sy = row ? -1. : 1.;
          jacobian[k] =
              sx * sy * ((x[0][i] - x[0][k]) * (x[1][j] - x[1][k]) - (x[1][i] - x[1][k]) * (x[0][j] - x[0][k]));
        }
      return jacobian;
    }

    /// Smallest corner Jacobian over the mean of the four: 1 in a parallelogram, below 0 where a corner is reflex.
    /// Without meaning where the mean is not positive.
    static double
    convexity(const CornerVectors<2> &x)
    {
      const auto j = corner_jacobian(x);
      return std::min(std::min(j[0], j[1]), std::min(j[2], j[3])) / (0.25 * (j[0] + j[1] + j[2] + j[3]));
    }

    /// Whether the smallest corner Jacobian is below this part of the mean of the four, or the mean is not positive.
    static bool
    folds(const CornerVectors<2> &x, double least_jacobian)
    {
      const auto   j    = corner_jacobian(x);
      const double mean = 0.25 * (j[0] + j[1] + j[2] + j[3]);
      return !(std::min(std::min(j[0], j[1]), std::min(j[2], j[3])) >= least_jacobian * mean && mean > 0);
    }

    /// Whether sides cross (two corners turned over) or the whole is turned over. An arrowhead, one reflex corner, is
    /// not: it covers the area that it is taken to have.
    static bool
    crosses(const CornerVectors<2> &x)
    {
      int    turned = 0;
      double sum    = 0;
      for (const double j : corner_jacobian(x))
        {
          turned += !(j >= 0);
          sum += j;
        }
      return turned > 1 || !(sum > 0);
    }
  };

  /// Exact integrals over a cell, with what the dimensions that are not computed add.
  template <int dim, Symmetry symmetry>
  struct CellGeometry;

  /// Quadrilateral, planar (per cm of depth) or swept about axis 1 (r = axis 0, 2 pi included).
  template <Symmetry symmetry>
  struct CellGeometry<2, symmetry> : CellShape<2>
  {
    /// Signed measure under one edge a -> b (Green): planar (x_a + x_b)/2 (y_b - y_a),
    /// axisymmetric 2 pi (r_a^2 + r_a r_b + r_b^2)/6 (z_b - z_a). Summed counter-clockwise it is the volume.
    template <typename Number>
    static Number
    edge_volume(const Number &ra, const Number &za, const Number &rb, const Number &zb)
    {
      if constexpr (symmetry == Symmetry::planar)
        return 0.5 * (ra + rb) * (zb - za);
      else
        return (std::numbers::pi / 3.) * (ra * ra + ra * rb + rb * rb) * (zb - za);
    }

    /// Volume of the quadrilateral (of revolution).
    template <typename Number>
    static Number
    volume(const CornerVectors<2, Number> &x)
    {
      Number sum = 0;
      for (int i = 0; i < 4; ++i)
        {
          const int a = walk[i], b = walk[(i + 1) % 4];
          sum += edge_volume(x[0][a], x[1][a], x[0][b], x[1][b]);
        }
      return sum;
    }

    /// dV/dx of every corner: the corner vectors B_k on which a pressure works, [axis][corner].
    template <typename Number>
    static CornerVectors<2, Number>
    volume_gradient(const CornerVectors<2, Number> &x)
    {
      CornerVectors<2, Number> gradient{};
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

    /// Integral of shape function N_k over the plane area (no radius), times 2 pi in axisymmetry:
    /// the weights h_k of the hoop rate, D_hoop = sum_k h_k v_r,k / V. Zero in planar symmetry.
    template <typename Number>
    static CornerValues<2, Number>
    hoop_weight(const CornerVectors<2, Number> &x)
    {
      CornerValues<2, Number> h{};
      if constexpr (symmetry == Symmetry::axisymmetric)
        {
          const CornerValues<2, Number> j = corner_jacobian(x);
          for (int k = 0; k < 4; ++k)
            h[k] = 2. * std::numbers::pi * (4. * j[k] + 2. * (j[k ^ 1] + j[k ^ 2]) + j[k ^ 3]) / 36.;
        }
      return h;
    }

    /// Mean extent of the cell, cm: square root of its area in the plane. @param hoop hoop_weight()
    template <typename Number>
    static Number
    mean_extent(const Number &volume, const CornerValues<2, Number> &hoop)
    {
      using std::max;
      using std::sqrt;
      Number area = volume;
      if constexpr (symmetry == Symmetry::axisymmetric)
        area = (hoop[0] + hoop[1] + hoop[2] + hoop[3]) * (0.5 / std::numbers::pi);
      return sqrt(max(area, Number(0.)));
    }

    /// Integral of shape function N_k over the true volume: how a uniform density splits over the corners.
    /// Their sum is the volume. First cell at the axis: 1/6 inside, 1/3 outside.
    static CornerValues<2>
    corner_volume(const CornerVectors<2> &x)
    {
      const CornerValues<2> j = corner_jacobian(x);
      CornerValues<2>       w{};
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
  };

  /// Call visit with the geometry of a mesh, CellGeometry<dim, symmetry>{}: for code outside hot loops.
  template <int dim, typename Visit>
  inline auto
  with_geometry(Symmetry symmetry, Visit &&visit)
  {
    return symmetry == Symmetry::planar ? visit(CellGeometry<dim, Symmetry::planar>{})
                                        : visit(CellGeometry<dim, Symmetry::axisymmetric>{});
  }

  /// CellGeometry::volume of a symmetry that is known at run time, cm^3.
  template <int dim = 2>
  inline double
  cell_volume(Symmetry symmetry, const CornerVectors<dim> &x)
  {
    return with_geometry<dim>(symmetry, [&x](auto geometry) { return geometry.volume(x); });
  }

  /// CellGeometry::corner_volume of a symmetry that is known at run time, cm^3.
  template <int dim = 2>
  inline CornerValues<dim>
  corner_volume(Symmetry symmetry, const CornerVectors<dim> &x)
  {
    return with_geometry<dim>(symmetry, [&x](auto geometry) { return geometry.corner_volume(x); });
  }
} // namespace whipple
