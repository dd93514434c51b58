// SPDX-License-Identifier: LGPL-2.1-or-later
#pragma once

#include <whipple/hydro/pack.h>
#include <whipple/mesh/geometry.h>

#include <array>

namespace whipple
{
  /// Volume-weighted mean velocity gradient of a cell, 1/us. Exact for velocities linear in position, in planar
  /// and in axisymmetric geometry.
  template <typename Number>
  struct VelocityGradient
  {
    std::array<std::array<Number, 2>, 2> l;    ///< l[i][j] = dv_i / dx_j
    Number                               hoop; ///< v_r / r; 0 in planar symmetry

    Number
    divergence() const
    {
      return l[0][0] + l[1][1] + hoop;
    }
  };

  /// L_ij = sum_k v_i,k g_j,k / V with g_k = B_k - h_k e_r, hoop rate sum_k h_k v_r,k / V.
  /// @param volume_gradient B_k, cm^2   @param hoop h_k, cm^2   @param v corner velocities, cm/us
  template <typename Number>
  inline VelocityGradient<Number>
  velocity_gradient(const geometry::QuadOf<Number> &volume_gradient, const std::array<Number, 4> &hoop,
                    const Number &volume, const geometry::QuadOf<Number> &v)
  {
    VelocityGradient<Number> gradient{};
    for (int k = 0; k < 4; ++k)
      {
        const Number g0 = volume_gradient[0][k] - hoop[k], g1 = volume_gradient[1][k];
        for (int i = 0; i < 2; ++i)
          {
            gradient.l[i][0] += v[i][k] * g0;
            gradient.l[i][1] += v[i][k] * g1;
          }
        gradient.hoop += v[0][k] * hoop[k];
      }
    const Number inverse = 1. / volume;
    for (int i = 0; i < 2; ++i)
      for (int j = 0; j < 2; ++j)
        gradient.l[i][j] *= inverse;
    gradient.hoop *= inverse;
    return gradient;
  }
} // namespace whipple
