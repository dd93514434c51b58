// SPDX-License-Identifier: LGPL-2.1-or-later
#pragma once

#include <whipple/exact/exact_factory.h>
#include <whipple/exact/guderley_passage.h>
#include <whipple/exact/rim_signal.h>

namespace whipple::exact
{
  /// Guderley's shock: a strong shock converges onto a line or point (n = 2, 3) of cold uniform ideal gas, arrives at
  /// time 0 and is reflected. Its radius is A (-t)^alpha, then A (t / B)^alpha; everything is a function of
  /// x = t (A / r)^(1/alpha): -1 at the shock, 0 at collapse, B at the reflected shock.
  ///
  ///   u = alpha A^(1/alpha) r^(1 - 1/alpha) v(x),   c^2 = (alpha A^(1/alpha) r^(1 - 1/alpha))^2 w(x),   rho = rho0
  ///   G(x)
  ///
  /// with v = U / x and w = Z / x^2 of SelfSimilarFlow, smooth through x = 0. [Guderley1942], [Lazarus1981];
  /// doc/theory/exact_gas.md.
  class Guderley : public Profile
  {
  public:
    struct Constants
    {
      int    dimensions = 3;                                       ///< n, 2 or 3
      double exponent   = 0;                                       ///< k > 1
      double density    = 0;                                       ///< rho0 ahead of the converging shock, g/cm^3
      double amplitude  = 0;                                       ///< A: radius of the shock 1 us before collapse, cm
      double extent     = std::numeric_limits<double>::infinity(); ///< of the gas at `start`, cm
      double start      = 0; ///< time from which the gas outside the extent is missing, us
    };

    /// @throws InputError for an exponent without such a solution.
    explicit Guderley(const Constants &constants);

    ProfileState
    at(double coordinate, double time) const override;

    /// Inside the first signal from the rim of the gas, which has run inwards with u - c since the start.
    bool
    counts(double coordinate, double time) const override;
    std::vector<double>
    breaks(double time) const override;
    std::optional<double>
    shock_position(double time) const override;

    double
    alpha() const
    {
      return flow.alpha;
    }
    double
    reflected_shock() const
    {
      return reflection;
    }

  private:
    /// Three functions over rising places, by cubic interpolation.
    struct Table
    {
      using Row = std::array<double, 3>;
      std::vector<double> place;
      std::vector<Row>    row;

      Row
      at(double x) const;
    };

    void
    tabulate_convergence(const ConvergingShock &shock);
    void
    tabulate_outflow();
    void
    tabulate_centre();
    void
    reflect();
    SelfSimilarState
    similarity_state(double x) const;
    SelfSimilarState
    behind_reflection(double x) const;

    Constants                constants;
    SelfSimilarFlow          flow;
    double                   reflection = 0; ///< B
    Table                    gas;            ///< v, w, ln G over x from -1 on
    Table                    centre;         ///< U, ln Z, ln G over y, behind the reflected shock
    std::optional<RimSignal> rim;
  };

  ExactKind
  guderley_kind();

  /// Exponent and density from the one body of the scene.
  std::unique_ptr<const ExactSolution<2>>
  make_guderley(const ExactRequest<2> &request);
} // namespace whipple::exact
