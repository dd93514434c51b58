// SPDX-License-Identifier: LGPL-2.1-or-later
#pragma once

#include <whipple/hydro/pack.h>
#include <whipple/mesh/cell_geometry.h>

#include <array>

namespace whipple
{
  /// Volume-weighted mean velocity gradient of a cell, 1/us. Exact for velocities linear in position, in planar
  /// and in axisymmetric geometry.
  template <int dim, typename Number>
  struct VelocityGradient
  {
    std::array<std::array<Number, dim>, dim> l;    ///< l[i][j] = dv_i / dx_j
    Number                                   hoop; ///< v_r / r; 0 in planar symmetry

    Number
    divergence() const
    {
      Number sum = l[0][0];
      for (int d = 1; d < dim; ++d)
        sum += l[d][d];
      return sum + hoop;
    }
  };

  /// g_k = B_k - h_k e_r: V times the mean gradient of the shape function of corner k.
  /// @param volume_gradient B_k, cm^2   @param hoop h_k, cm^2
  template <int dim, typename Number>
  inline std::array<Number, dim>
  shape_gradient(int k, const CornerVectors<dim, Number> &volume_gradient, const CornerValues<dim, Number> &hoop)
  {
    std::array<Number, dim> g;
    g[0] = volume_gradient[0][k] - hoop[k];
    for (int d = 1; d < dim; ++d)
      g[d] = volume_gradient[d][k];
    return g;
  }

  /// L_ij = sum_k v_i,k g_j,k / V, hoop rate sum_k h_k v_r,k / V.
  /// @param volume_gradient B_k, cm^2   @param hoop h_k, cm^2   @param v corner velocities, cm/us
  template <int dim, typename Number>
  inline VelocityGradient<dim, Number>
  velocity_gradient(const CornerVectors<dim, Number> &volume_gradient, const CornerValues<dim, Number> &hoop,
                    const Number &volume, const CornerVectors<dim, Number> &v)
  {
    VelocityGradient<dim, Number> gradient{};
    for (int k = 0; k < (1 << dim); ++k)
      {
        const std::array<Number, dim> g = shape_gradient<dim>(k, volume_gradient, hoop);
        for (int i = 0; i < dim; ++i)
          for (int j = 0; j < dim; ++j)
            gradient.l[i][j] += v[i][k] * g[j];
        gradient.hoop += v[0][k] * hoop[k];
      }
    const Number inverse = 1. / volume;
    for (int i = 0; i < dim; ++i)
      for (int j = 0; j < dim; ++j)
        gradient.l[i][j] *= inverse;
    gradient.hoop *= inverse;
    return gradient;
  }
} // namespace whipple
