// SPDX-License-Identifier: LGPL-2.1-or-later
#pragma once

#include <algorithm>

/// The curve P_ref(gamma) at e = 0 that laws of the Mie-Grueneisen kind are written about, in units of K = gamma0 c0^2;
/// chi = 1 - gamma0/gamma, mu = gamma/gamma0 - 1, v = gamma0/gamma (doc/theory/equation_of_state.md).
namespace whipple
{
  /// U_s = c0 + s u, so U_s = c0 / D with D = 1 - s chi. The members are the parts of D that the curve needs.
  struct LinearHugoniot
  {
    double s; ///< >= 0

    /// (1 - D) / chi
    double
    steepness(double) const
    {
      return s;
    }
    /// (D - 2 chi D' - 1) / chi: that the pressure on the Hugoniot rises with density means 1 + rise chi > 0.
    double
    rise(double) const
    {
      return s;
    }
    /// D - chi D'
    double
    intercept(double) const
    {
      return 1.;
    }
  };

  /// U_s = c0 + s1 u + s2 u^2/U_s + s3 u^3/U_s^2, so D = 1 - s1 chi - s2 chi^2 - s3 chi^3.
  struct CubicHugoniot
  {
    double s1, s2, s3;

    double
    steepness(double chi) const
    {
      return s1 + (s2 + s3 * chi) * chi;
    }
    double
    rise(double chi) const
    {
      return s1 + (3. * s2 + 5. * s3 * chi) * chi;
    }
    double
    intercept(double chi) const
    {
      return 1. + (s2 + 2. * s3 * chi) * chi * chi;
    }
  };

  /// P_ref / K and (gamma0 / K) dP_ref/dgamma at constant Gamma gamma / gamma0 = grueneisen.
  struct ReferenceCurve
  {
    double pressure;
    double slope;
    double hugoniot; ///< P_H / K, 0 in expansion
  };

  /// P_H / K = chi / D^2 and P_ref = P_H (1 - grueneisen chi / 2) in compression, P_ref / K = mu (1 + mu^2 v) in
  /// expansion. Both branches are computed and the right one taken, so that loops over it vectorise.
  template <class Hugoniot>
  inline ReferenceCurve
  reference_curve(const Hugoniot &hugoniot, double compression, double v, double grueneisen)
  {
    const double chi         = std::max(1. - v, 0.);
    const double steepening  = 1. / (1. - hugoniot.steepness(chi) * chi);
    const double steepening2 = steepening * steepening;
    const double mu          = std::min(compression - 1., 0.);
    const double mu2         = mu * mu;

    const double compressed_slope =
        v * v * (1. + (hugoniot.rise(chi) - grueneisen * hugoniot.intercept(chi)) * chi) * steepening2 * steepening;
    const double expanded_slope = 1. + mu2 * (2. + v) * v;
    // One of chi and mu is zero, and with it its term.
    return {chi * (1. - 0.5 * grueneisen * chi) * steepening2 + mu * (1. + mu2 * v),
            chi > 0. ? compressed_slope : expanded_slope, chi * steepening2};
  }
} // namespace whipple
