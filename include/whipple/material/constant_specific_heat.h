// SPDX-License-Identifier: LGPL-2.1-or-later
#pragma once

#include <whipple/material/cubic_table.h>
#include <whipple/material/equation_of_state.h>
#include <whipple/material/reference_isentrope.h>
#include <whipple/material/thermal_model.h>

#include <limits>
#include <optional>

namespace whipple
{
  /// Temperature and phases beside an equation of state that knows neither. doc/theory/melting.md.
  ///
  /// Without a change of phase T = e / cv + theta(v) (ReferenceIsentrope). At T_m(v) energy melts instead of heating:
  /// the melt fraction grows linearly with e at a given density until the heat of fusion is used up. In expanded states
  /// the same happens at the boiling temperature. Both heats are those at zero pressure, along the law's line P = 0.
  class ConstantSpecificHeat : public ThermalModel
  {
  public:
    static constexpr double infinite = std::numeric_limits<double>::infinity();

    struct Constants
    {
      double specific_heat         = 0;    ///< cv [Mbar cm^3/(g K)], > 0
      double reference_temperature = 300.; ///< of e = 0 at gamma0 [K], >= 0

      double melting_point     = infinite; ///< T_m at zero pressure [K]; infinite: never melts
      double heat_of_fusion    = 0;        ///< at zero pressure [Mbar cm^3/g], > 0
      double grueneisen        = 0;        ///< Gamma0 of the melting law
      double volume_correction = 0;        ///< a of the melting law

      double boiling_point        = infinite; ///< T_b at zero pressure [K]; infinite: never boils
      double heat_of_vaporisation = 0;        ///< at zero pressure [Mbar cm^3/g], > 0
    };

    /// @throws InputError for constants outside their ranges, temperatures in the wrong order, and laws that do not
    /// reach the melting point at zero pressure. A law that does not reach the boiling point there never boils.
    ConstantSpecificHeat(const EquationOfState &eos, const Constants &constants);

    void
    evaluate(std::span<const double> density, std::span<const double> energy,
             const ThermalOutput &output) const override;
    double
    specific_heat() const override;
    Transitions
    transitions() const override;
    std::string
    name() const override;

  private:
    struct Point
    {
      double temperature, melt_temperature, melt_fraction, vapour_fraction;
    };

    struct ZeroPressure
    {
      double v, energy;
    };

    /// First state on the line P = 0 that is as hot as `wanted` [K]; empty if there is none.
    std::optional<ZeroPressure>
    reach(const EquationOfState &eos, double wanted) const;

    void
    set_melting(const EquationOfState &eos);
    void
    set_boiling(const EquationOfState &eos);

    Point
    point(double v, double energy) const;

    Constants          constants_;
    double             reference_density_;
    ReferenceIsentrope isentrope_;
    CubicTable         melt_temperature_;          ///< K, of v up to melting_volume_
    double             melting_volume_ = infinite; ///< gamma0 / gamma of the solid at its melting point, P = 0
    double             melting_point_  = infinite; ///< K
    double             fusion_         = 1.;       ///< heat of fusion at constant density, Mbar cm^3/g
    double             boiling_volume_ = infinite; ///< gamma0 / gamma of the liquid at its boiling point, P = 0
    double             boiling_point_  = infinite; ///< K
    double             vaporisation_   = 1.;       ///< heat of vaporisation at constant density, Mbar cm^3/g
    Transitions        transitions_{infinite, infinite, infinite, infinite};
  };
} // namespace whipple
