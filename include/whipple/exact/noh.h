// SPDX-License-Identifier: LGPL-2.1-or-later
#pragma once

#include <whipple/exact/exact_factory.h>

namespace whipple::exact
{
  /// Noh's implosion: cold ideal gas falls with uniform speed U towards a plane, a line or a point (n = 1, 2, 3) and
  /// stops in a shock that walks out at D = (k - 1) U / 2. With r the coordinate and t the time since the start,
  ///
  ///   ahead  (r > D t): rho = rho0 (1 + U t / r)^(n - 1), u = -U, p = 0, e = 0,
  ///   behind (r < D t): rho = rho0 ((k + 1) / (k - 1))^n, u = 0, e = U^2 / 2, p = (k - 1) rho e.
  ///
  /// [Noh1987]; doc/theory/exact_gas.md.
  class Noh : public Profile
  {
  public:
    struct Constants
    {
      int    dimensions = 3;                                       ///< n
      double exponent   = 0;                                       ///< k > 1
      double density    = 0;                                       ///< rho0, g/cm^3
      double velocity   = 0;                                       ///< U > 0, cm/us
      double extent     = std::numeric_limits<double>::infinity(); ///< gas starts inside this distance, cm
    };

    explicit Noh(const Constants &constants);

    ProfileState
    at(double coordinate, double time) const override;

    /// Gas that started within 95 % of the extent: near its rim the falling gas ends in cells that are partly empty.
    bool
    counts(double coordinate, double time) const override;
    std::vector<double>
    breaks(double time) const override;
    std::optional<double>
    shock_position(double time) const override;

  private:
    Constants constants;
    double    shock_speed;
  };

  ExactKind
  noh_kind();

  /// Exponent and density from the one body of the scene.
  std::unique_ptr<const ExactSolution<2>>
  make_noh(const ExactRequest<2> &request);
} // namespace whipple::exact
