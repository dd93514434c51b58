// SPDX-License-Identifier: LGPL-2.1-or-later
#pragma once

#include <whipple/exact/exact_factory.h>

namespace whipple::exact
{
  /// Sedov's explosion: energy E set free at time 0 in a plane, line or point (n = 1, 2, 3) of a cold uniform ideal
  /// gas. The shock is at R = (E / (alpha rho0))^(1/(n+2)) t^(2/(n+2)); behind it everything is a function of r / R in
  /// closed form (notation of [Kamm2007]), of which alpha is an integral.
  /// doc/theory/exact_gas.md.
  class Sedov : public Profile
  {
  public:
    struct Constants
    {
      int    dimensions = 3; ///< n
      double exponent   = 0; ///< k > 1, k != 2; below 7 for n = 3
      double density    = 0; ///< rho0, g/cm^3
      double energy =
          0; ///< E of a point; of a line per cm; of a plane per cm^2 and to one side; Mbar cm^3 (/cm, /cm^2)
      double extent = std::numeric_limits<double>::infinity(); ///< of the gas, cm
    };

    /// @throws InputError for exponents that the closed form does not cover.
    explicit Sedov(const Constants &constants);

    ProfileState
    at(double coordinate, double time) const override;

    /// While the shock is inside the extent.
    bool
    counts(double coordinate, double time) const override;
    std::vector<double>
    breaks(double time) const override;
    std::optional<double>
    shock_position(double time) const override;

    double
    alpha() const
    {
      return energy_integral;
    }

  private:
    /// Similarity functions, 1 at the shock, of the depth y = -ln((V - V0) / (V2 - V0)): V is Sedov's velocity
    /// variable.
    struct Shape
    {
      double log_position; ///< ln(r / R)
      double slope;        ///< of log_position over y
      double velocity, density, pressure;
    };

    Shape
    shape(double depth) const;
    double
    depth_at(double log_position) const;
    double
    integrate_energy() const;

    Constants           constants;
    double              energy_integral = 1;
    std::vector<double> log_positions; ///< over equal steps of the depth, falling
  };

  ExactKind
  sedov_kind();

  /// Exponent and density from the one body of the scene; energy from the constant "Total energy" or, if that is zero,
  /// from the energy deposited in the body: multiplied by two for each side of the domain at coordinate 0 that reflects
  /// and cuts the flow in half, per cm or per cm^2 and side.
  std::unique_ptr<const ExactSolution<2>>
  make_sedov(const ExactRequest<2> &request);
} // namespace whipple::exact
