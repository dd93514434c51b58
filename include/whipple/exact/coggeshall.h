// SPDX-License-Identifier: LGPL-2.1-or-later
#pragma once

#include <whipple/exact/exact_factory.h>
#include <whipple/exact/rim_signal.h>

namespace whipple::exact
{
  /// Free expansion of an ideal gas under a pressure uniform in space, the nearest exact relative of a debris cloud:
  /// with n = 1, 2, 3 and times and lengths in units of 1 us and 1 cm,
  ///
  ///   u = r / t,   rho = rho1 r^b t^(-b-n),   p = p1 t^(-k n),   e = p / ((k - 1) rho).
  ///
  /// Solution 1 of [Coggeshall1991], for any b. Solution 8 of the same paper is this
  /// flow with b = (n - 2) / (beta - alpha + 4), at which a heat flux ~ rho^alpha T^(beta+3) grad T has no divergence.
  /// doc/theory/exact_gas.md.
  class Coggeshall : public Profile
  {
  public:
    struct Constants
    {
      int    dimensions = 3;                                       ///< n
      double exponent   = 0;                                       ///< k > 1
      double power      = 0;                                       ///< b
      double density    = 0;                                       ///< rho1, at 1 cm and 1 us, g/cm^3
      double pressure   = 0;                                       ///< p1, at 1 us, Mbar
      double extent     = std::numeric_limits<double>::infinity(); ///< of the gas at `start`, cm
      double start      = 1;                                       ///< us, > 0
    };

    explicit Coggeshall(const Constants &constants);

    ProfileState
    at(double coordinate, double time) const override;

    /// Inside the first signal from the rim of the gas.
    bool
    counts(double coordinate, double time) const override;

  private:
    Constants constants;
    RimSignal rim;
  };

  ExactKind
  coggeshall_1_kind();
  ExactKind
  coggeshall_8_kind();

  /// Exponent from the one body of the scene.
  std::unique_ptr<const ExactSolution<2>>
  make_coggeshall_1(const ExactRequest<2> &request);
  std::unique_ptr<const ExactSolution<2>>
  make_coggeshall_8(const ExactRequest<2> &request);
} // namespace whipple::exact
