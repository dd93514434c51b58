// SPDX-License-Identifier: LGPL-2.1-or-later
#pragma once

#include <whipple/material/void_law.h>

#include <limits>

namespace whipple
{
  /// P-alpha compaction of porous material. With the distension alpha = 1 / (1 - phi) = gamma / rho and the bulk
  /// pressure P = P_s(gamma, e) / alpha, pores crush along
  ///
  ///   alpha = 1 + (alpha0 - 1) [(P_c - P) / (P_c - P_e)]^2,   P_e <= P <= P_c,   alpha0 = 1 / (1 - phi0),
  ///
  /// and are gone at P >= P_c. Below the curve alpha is frozen, so pores never grow under pressure. Tension of the
  /// solid beyond the spall strength opens pores to P_s = 0; material that is looser than phi0 closes to phi0 without
  /// resistance. [Herrmann1969], with the quadratic curve; doc/theory/voids.md.
  class PAlphaVoidLaw : public VoidLaw
  {
  public:
    struct Constants
    {
      double initial_porosity         = 0; ///< phi0, in (0, 1)
      double elastic_crush_pressure   = 0; ///< P_e [Mbar] >= 0: bulk pressure at which crushing begins
      double full_compaction_pressure = 0; ///< P_c [Mbar] > P_e: bulk pressure at which no pore is left
      double spall_strength           = std::numeric_limits<double>::infinity(); ///< [Mbar] >= 0, tension of the solid
    };

    /// @throws InputError for constants outside their ranges.
    explicit PAlphaVoidLaw(const Constants &constants);

    /// dt does not matter: crushing is immediate.
    void
    advance(const EquationOfState &eos, double dt, const VoidInput &state,
            std::span<double> void_fraction) const override;
    double
    initial_void_fraction() const override;
    double
    yielding(const EquationOfState &eos) const override;
    std::string
    name() const override;

    const Constants &
    constants() const
    {
      return constants_;
    }

  private:
    Constants constants_;
  };
} // namespace whipple
