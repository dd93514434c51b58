// SPDX-License-Identifier: LGPL-2.1-or-later
#pragma once

#include <whipple/hydro/velocity_gradient.h>
#include <whipple/hydro/viscosity.h>

/// Tensor viscosity in the directions of principal compression, the fourth kind of [Kolev2009], with the limiter of the
/// scalar one. Equations: doc/theory/viscosity.md.
namespace whipple::viscosity
{
  /// Symmetric stress in the plane of motion, tension positive, Mbar.
  template <typename Number>
  struct PlaneStress
  {
    Number s00, s11, s01;

    /// Its product with a vector.
    std::array<Number, 2>
    on(const std::array<Number, 2> &g) const
    {
      return {s00 * g[0] + s01 * g[1], s01 * g[0] + s11 * g[1]};
    }
  };

  /// One principal direction s of the rate of deformation.
  template <typename Number>
  struct PrincipalDirection
  {
    Number rate;          ///< eigenvalue, 1/us
    Number s00, s11, s01; ///< s s^T
  };

  /// sum over the compressed principal directions of mu lambda s s^T.
  /// @param psi shares of compression that the neighbours continue along the two logical directions (limiter())
  template <typename Number>
  inline PlaneStress<Number>
  tensor_stress(const HydroParameters &parameters, const CornerVectors<2, Number> &x,
                const VelocityGradient<2, Number> &gradient, const Number &density, const Number &sound_speed,
                const std::array<Number, 2> &psi)
  {
    using std::max;
    using std::sqrt;
    const Number mean = 0.5 * (gradient.l[0][0] + gradient.l[1][1]), half = 0.5 * (gradient.l[0][0] - gradient.l[1][1]);
    const Number shear = 0.5 * (gradient.l[0][1] + gradient.l[1][0]), radius = sqrt(half * half + shear * shear);
    const auto   turned  = radius > Number(smallest_rate);
    const Number inverse = 0.5 / select(turned, radius, Number(1.));
    const Number c       = select(turned, Number(half * inverse), Number(0.)),
                 s       = select(turned, Number(shear * inverse), Number(0.));

    PlaneStress<Number> stress{0., 0., 0.};
    for (const PrincipalDirection<Number> &direction : {PrincipalDirection<Number>{mean - radius, 0.5 - c, 0.5 + c, -s},
                                                        PrincipalDirection<Number>{mean + radius, 0.5 + c, 0.5 - c, s}})
      {
        // no more than the plane area shrinks: shear that hardly compresses is no shock
        const Number rate = max(direction.rate, Number(2. * mean));
        Number       square(0.), shared(0.);
        for (int d = 0; d < 2; ++d)
          {
            const Number e0 = along(d, x[0]), e1 = along(d, x[1]);
            const Number part = e0 * e0 * direction.s00 + 2. * e0 * e1 * direction.s01 + e1 * e1 * direction.s11;
            square += part;
            shared += part * psi[d];
          }
        const Number limited = shared / square, jump = -rate * sqrt(square);
        const Number p = select(rate < Number(-smallest_rate),
                                Number(density * (1. - limited) * jump *
                                       (parameters.quadratic_viscosity * (1. + limited) * jump +
                                        parameters.linear_viscosity * sound_speed)),
                                Number(0.));
        stress.s00 -= p * direction.s00;
        stress.s11 -= p * direction.s11;
        stress.s01 -= p * direction.s01;
      }
    return stress;
  }
} // namespace whipple::viscosity
