// SPDX-License-Identifier: LGPL-2.1-or-later
#pragma once

#include <array>
#include <optional>
#include <vector>

namespace whipple::exact
{
  /// Ordinary differential equations of a self-similar flow r ~ |t|^alpha of an ideal gas. With y = ln(r / |t|^alpha),
  ///
  ///   u = alpha (r / t) U(y),   c^2 = alpha^2 (r / t)^2 Z(y),   rho = rho0 G(y),   lambda = 1 / alpha,
  ///   sigma = (2 / k) (lambda - 1),   D = (U - 1)^2 - Z,
  ///   N = -U (U - 1) (U - lambda) + Z (n U - sigma),
  ///   U' = N / D,   (ln Z)' = -((k - 1) (U' + n U) + 2 (U - lambda)) / (U - 1),   (ln G)' = -(U' + n U) / (U - 1).
  struct SelfSimilarFlow
  {
    double dimensions = 3; ///< n: 2 or 3
    double exponent   = 0; ///< k
    double alpha      = 0;

    double
    sigma() const
    {
      return 2. / exponent * (1. / alpha - 1.);
    }
  };

  /// State on a solution of those equations.
  struct SelfSimilarState
  {
    double y = 0, velocity = 0, sound_square = 0, log_density = 0; ///< y, U, Z, ln G
  };

  /// The solution that passes analytically through a singular point N = D = 0, where sound moves with the wave.
  class SonicPassage
  {
  public:
    static constexpr int order = 10;
    using Series               = std::array<double, order + 1>;

    /// The analytic solution with the steeper of its two directions' signs, dZ/dU > 0, through the singular point of
    /// larger (or smaller) U; none where the point or the direction does not exist.
    static std::optional<SonicPassage>
    through(const SelfSimilarFlow &flow, bool larger);

    /// U of the singular point.
    double
    velocity() const
    {
      return point;
    }

    /// State at a U near the point, with y and ln G counted from there.
    SelfSimilarState
    at(double velocity) const;

  private:
    double point = 0;
    Series sound_square{}, y{}, log_density{}; ///< in powers of U - U of the point
  };

  /// States from U = `from` (state given) to U = `to` in equal steps of U, by the classical Runge-Kutta scheme; the
  /// singular points must lie outside.
  std::vector<SelfSimilarState>
  follow_velocity(const SelfSimilarFlow &flow, const SelfSimilarState &from, double to, int steps);

  /// State behind a strong shock into gas at rest, at y = 0.
  SelfSimilarState
  behind_strong_shock(const SelfSimilarFlow &flow);

  /// A converging shock that stays analytic where sound moves with it: its exponent and its passage.
  struct ConvergingShock
  {
    SelfSimilarFlow flow;
    SonicPassage    passage;
  };

  /// The exponent alpha for which the state behind the shock lies on the analytic solution.
  /// @throws InputError if there is none between 0.5 and 1.
  ConvergingShock
  find_converging_shock(int dimensions, double exponent);
} // namespace whipple::exact
