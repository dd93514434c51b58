// SPDX-License-Identifier: LGPL-2.1-or-later
#pragma once

#include <whipple/hydro/pack.h>

/// Elastic-plastic flow of the solid with the radial return of [Wilkins1964]. Number is double or Pack.
/// Equations: doc/theory/lagrange_step.md, section "Strength".
namespace whipple::plasticity
{
  /// Deviatoric stress, Mbar; the component out of the plane (hoop) is -(s_00 + s_11).
  template <typename Number>
  struct Deviator
  {
    Number s00, s11, s01;
  };

  /// Mean rates of a cell, 1/us: deviatoric rate of deformation and spin w = (dv_1/dx_0 - dv_0/dx_1) / 2.
  template <typename Number>
  struct Rates
  {
    Number d00, d11, d01, spin;
  };

  /// Deviator and spin of a velocity gradient L_ij = dv_i/dx_j with the out-of-plane rate `hoop`.
  template <typename Number>
  inline Rates<Number>
  rates(const Number &l00, const Number &l01, const Number &l10, const Number &l11, const Number &hoop)
  {
    const Number third = (l00 + l11 + hoop) / 3.;
    return {l00 - third, l11 - third, 0.5 * (l01 + l10), 0.5 * (l10 - l01)};
  }

  /// Stress turned with the material by the exact rotation that belongs to a spin at mid step:
  /// tan(angle / 2) = spin dt / 2.
  template <typename Number>
  inline Deviator<Number>
  rotate(const Deviator<Number> &s, const Number &spin, double dt)
  {
    const Number t      = 0.5 * dt * spin;
    const Number scale  = 1. / (1. + t * t);
    const Number cosine = (1. - t * t) * scale, sine = 2. * t * scale;
    const Number mean = 0.5 * (s.s00 + s.s11), half = 0.5 * (s.s00 - s.s11);
    const Number cosine2 = cosine * cosine - sine * sine, sine2 = 2. * sine * cosine;
    const Number turned = half * cosine2 - s.s01 * sine2;
    return {mean + turned, mean - turned, s.s01 * cosine2 + half * sine2};
  }

  /// s + 2 G D dt.
  template <typename Number>
  inline Deviator<Number>
  stretch(const Deviator<Number> &s, const Rates<Number> &rate, const Number &shear_modulus, double dt)
  {
    const Number g = 2. * dt * shear_modulus;
    return {s.s00 + g * rate.d00, s.s11 + g * rate.d11, s.s01 + g * rate.d01};
  }

  /// Equivalent stress sqrt(3/2 s:s).
  template <typename Number>
  inline Number
  equivalent_stress(const Deviator<Number> &s)
  {
    using std::sqrt;
    const Number hoop = s.s00 + s.s11;
    return sqrt(1.5 * (s.s00 * s.s00 + s.s11 * s.s11 + hoop * hoop + 2. * s.s01 * s.s01));
  }

  /// The smallest principal value, <= 0: the pressure of a surface that bears no stress across the direction in which
  /// the solid is pushed most (or pulled least).
  template <typename Number>
  inline Number
  least_principal(const Deviator<Number> &s)
  {
    using std::sqrt;
    const Number mean = 0.5 * (s.s00 + s.s11), half = 0.5 * (s.s00 - s.s11);
    const Number in_plane = mean - sqrt(half * half + s.s01 * s.s01), hoop = -2. * mean;
    return select(hoop < in_plane, hoop, in_plane);
  }

  /// Scale s back to the yield surface where it lies outside; s_eq is its equivalent stress.
  template <typename Number>
  inline Deviator<Number>
  return_radially(const Deviator<Number> &s, const Number &s_eq, const Number &yield_stress)
  {
    const Number factor = select(s_eq > yield_stress, Number(yield_stress / s_eq), Number(1.));
    return {factor * s.s00, factor * s.s11, factor * s.s01};
  }

  /// Increment of the equivalent plastic strain that the return stands for; 0 in a melt (G = 0).
  template <typename Number>
  inline Number
  plastic_increment(const Number &s_eq, const Number &yield_stress, const Number &shear_modulus)
  {
    return select(s_eq > yield_stress && shear_modulus > Number(0.),
                  Number((s_eq - yield_stress) / (3. * shear_modulus)), Number(0.));
  }
} // namespace whipple::plasticity
