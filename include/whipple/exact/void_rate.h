// SPDX-License-Identifier: LGPL-2.1-or-later
#pragma once

#include <whipple/exact/exact_factory.h>

namespace whipple::exact
{
  /// The rate void law at fixed bulk density rho in a solid with the linear law P_s = K (g - 1), g = gamma / gamma0:
  /// phi_dot = -(alpha rho / gamma0^2) P_s is g_dot = -lambda g^2 (g - 1) with lambda = alpha K / gamma0, so
  ///
  ///   lambda t = -[ln(|g - 1| / g) + 1 / g]  taken from g(0) to g(t),   phi = 1 - rho / (gamma0 g).
  ///
  /// doc/theory/voids.md.
  class VoidRate
  {
  public:
    struct Constants
    {
      double reference_density = 0; ///< gamma0, g/cm^3
      double bulk_modulus      = 0; ///< K, Mbar
      double alpha             = 0; ///< us/cm^2
      double bulk_density      = 0; ///< rho, g/cm^3
      double void_fraction     = 0; ///< phi at time 0, in [0, 1)
    };

    explicit VoidRate(const Constants &constants);

    /// g at a time >= 0 [us]; 1 stays 1.
    double
    density_ratio(double time) const;

    /// phi at a time. In compression only until the void is closed (closing_time()); negative after.
    double
    void_fraction(double time) const;

    /// P_s, Mbar.
    double
    solid_pressure(double time) const;

    /// When the void of a compressed state is closed, us; infinite if it never is.
    double
    closing_time() const;

  private:
    /// lambda t of a density ratio, up to a constant.
    static double
    clock(double density_ratio);

    Constants constants;
    double    rate_;        ///< lambda, 1/us
    double    start_ratio_; ///< g(0)
  };

  /// A body at rest, uniform and confined, whose void fraction follows VoidRate: the pressure (1 - phi) P_s relaxes.
  class VoidRelaxation : public ExactSolution<2>
  {
  public:
    /// @param density bulk, g/cm^3
    /// @param energy  Mbar cm^3/g
    VoidRelaxation(std::string name, const VoidRate &law, double density, double energy, double start);

    PointState<2>
    at(const Vector<2> &x, double time) const override;

  private:
    VoidRate law_;
    double   density_, energy_, start_;
  };

  ExactKind
  void_relaxation_kind();

  /// The one body of the scene, at rest, stretched below its reference density, of a linear law with the rate void law,
  /// between reflecting sides.
  std::unique_ptr<const ExactSolution<2>>
  make_void_relaxation(const ExactRequest<2> &request);
} // namespace whipple::exact
