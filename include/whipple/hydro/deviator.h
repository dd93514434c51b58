// SPDX-License-Identifier: LGPL-2.1-or-later
#pragma once

#include <whipple/hydro/pack.h>
#include <whipple/hydro/velocity_gradient.h>
#include <whipple/state/fields.h>

#include <array>

/// Deviatoric stress of the solid: where it is stored, how it turns with the material, stretches, flows (radial return
/// of [Wilkins1964]) and pulls at the corners of a cell. Number is double or Pack. Only two dimensions exist; what a
/// third one needs is a second set of Deviator and DeformationRate (doc/dimensions.md).
/// Equations: doc/theory/lagrange_step.md, section "Strength".
namespace whipple
{
  /// Symmetric tensor without trace; stress in Mbar.
  template <int dim, typename Number = double>
  struct Deviator;

  /// Deviator of the rate of deformation and spin of a cell, 1/us.
  template <int dim, typename Number>
  struct DeformationRate;

  /// In a plane: the component out of it (hoop) is -(s_00 + s_11).
  template <typename Number>
  struct Deviator<2, Number>
  {
    std::array<Number, DeviatorStorage<2>::size> component; ///< s_00, s_11, s_01

    static Deviator
    zero()
    {
      return {{Number(0.), Number(0.), Number(0.)}};
    }

    /// s_aa of an axis.
    Number
    normal(int axis) const
    {
      return component[axis];
    }

    /// s_01.
    Number
    shear() const
    {
      return component[2];
    }

    /// Turned with the material by the exact rotation that belongs to a spin at mid step: tan(angle / 2) = spin dt / 2.
    /// @param spin w = (dv_1/dx_0 - dv_0/dx_1) / 2, 1/us
    Deviator
    turned(const Number &spin, double dt) const
    {
      const auto &[s00, s11, s01] = component;
      const Number t              = 0.5 * dt * spin;
      const Number scale          = 1. / (1. + t * t);
      const Number cosine = (1. - t * t) * scale, sine = 2. * t * scale;
      const Number mean = 0.5 * (s00 + s11), half = 0.5 * (s00 - s11);
      const Number cosine2 = cosine * cosine - sine * sine, sine2 = 2. * sine * cosine;
      const Number turned = half * cosine2 - s01 * sine2;
      return {{mean + turned, mean - turned, s01 * cosine2 + half * sine2}};
    }

    /// Equivalent stress sqrt(3/2 s:s).
    Number
    equivalent() const
    {
      using std::sqrt;
      const auto &[s00, s11, s01] = component;
      const Number hoop           = s00 + s11;
      return sqrt(1.5 * (s00 * s00 + s11 * s11 + hoop * hoop + 2. * s01 * s01));
    }

    /// The smallest principal value, <= 0: the pressure of a surface that bears no stress across the direction in which
    /// the solid is pushed most (or pulled least).
    Number
    least_principal() const
    {
      using std::sqrt;
      const auto &[s00, s11, s01] = component;
      const Number mean = 0.5 * (s00 + s11), half = 0.5 * (s00 - s11);
      const Number in_plane = mean - sqrt(half * half + s01 * s01), hoop = -2. * mean;
      return select(hoop < in_plane, hoop, in_plane);
    }

    /// What it pulls a corner with towards the cell, along each axis; the pressure's force is P B_k.
    /// @param g shape_gradient() of the corner, cm^2   @param hoop its hoop weight, cm^2
    std::array<Number, 2>
    pull(const std::array<Number, 2> &g, const Number &hoop) const
    {
      const auto &[s00, s11, s01] = component;
      return {s00 * g[0] + s01 * g[1] - (s00 + s11) * hoop, s01 * g[0] + s11 * g[1]};
    }
  };

  template <typename Number>
  struct DeformationRate<2, Number>
  {
    Deviator<2, Number> deviator;
    Number              spin; ///< (dv_1/dx_0 - dv_0/dx_1) / 2

    explicit DeformationRate(const VelocityGradient<2, Number> &gradient)
      : DeformationRate(gradient, (gradient.l[0][0] + gradient.l[1][1] + gradient.hoop) / 3.)
    {
    }

  private:
    DeformationRate(const VelocityGradient<2, Number> &gradient, const Number &third)
      : deviator{{gradient.l[0][0] - third, gradient.l[1][1] - third, 0.5 * (gradient.l[0][1] + gradient.l[1][0])}}
      , spin(0.5 * (gradient.l[1][0] - gradient.l[0][1]))
    {
    }
  };

  /// a + factor b, component by component.
  template <int dim, typename Number>
  inline Deviator<dim, Number>
  add_scaled(const Deviator<dim, Number> &a, const Number &factor, const Deviator<dim, Number> &b)
  {
    Deviator<dim, Number> sum;
    for (std::size_t i = 0; i < a.component.size(); ++i)
      sum.component[i] = a.component[i] + factor * b.component[i];
    return sum;
  }

  /// Elastic trial stress after dt: turned with the material, plus 2 G D dt.
  template <int dim, typename Number>
  inline Deviator<dim, Number>
  elastic_trial(const Deviator<dim, Number> &s, const DeformationRate<dim, Number> &rate, const Number &shear_modulus,
                double dt)
  {
    return add_scaled(s.turned(rate.spin, dt), Number(2. * dt * shear_modulus), rate.deviator);
  }

  /// Scaled back to the yield surface where it lies outside. @param equivalent its equivalent stress
  template <int dim, typename Number>
  inline Deviator<dim, Number>
  returned(Deviator<dim, Number> s, const Number &equivalent, const Number &yield_stress)
  {
    const Number factor = select(equivalent > yield_stress, Number(yield_stress / equivalent), Number(1.));
    for (Number &component : s.component)
      component = factor * component;
    return s;
  }

  /// Increment of the equivalent plastic strain that the return stands for; 0 in a melt (G = 0).
  template <typename Number>
  inline Number
  plastic_increment(const Number &equivalent, const Number &yield_stress, const Number &shear_modulus)
  {
    return select(equivalent > yield_stress && shear_modulus > Number(0.),
                  Number((equivalent - yield_stress) / (3. * shear_modulus)), Number(0.));
  }

  /// The deviators that one material of a state holds, by cell.
  template <int dim>
  class StoredDeviator
  {
  public:
    StoredDeviator(const MaterialState &material, const FieldIndex<dim> &index)
    {
      for (std::size_t i = 0; i < field_.size(); ++i)
        field_[i] = &material.fields[index.stress[i]].value;
    }

    Deviator<dim>
    at(Index cell) const
    {
      Deviator<dim> s;
      for (std::size_t i = 0; i < field_.size(); ++i)
        s.component[i] = (*field_[i])[cell];
      return s;
    }

    /// Of the cells first, first + 1, ... of a pack.
    Deviator<dim, Pack>
    load(Index first) const
    {
      Deviator<dim, Pack> s;
      for (std::size_t i = 0; i < field_.size(); ++i)
        s.component[i] = whipple::load(*field_[i], first);
      return s;
    }

  private:
    std::array<const std::vector<double> *, DeviatorStorage<dim>::size> field_;
  };
} // namespace whipple
