// SPDX-License-Identifier: LGPL-2.1-or-later
#pragma once

#include <whipple/material/equation_of_state.h>
#include <whipple/material/pointwise.h>
#include <whipple/material/release_line.h>
#include <whipple/material/thermal_model.h>

namespace whipple
{
  /// Aluminium that melts and boils: solid and fluid from their Helmholtz free energies, mixtures of solid and liquid
  /// and of liquid and vapour in equilibrium of pressure, temperature and Gibbs energy. Pressure and temperature belong
  /// together (Maxwell), except in tension:
  ///
  ///   P = P_eq + (1 - S) K f(gamma / gamma_r),   f(y) = (y - 1)(1 + (y - 1)^2 / y)    for gamma < gamma_r(e),
  ///
  /// where condensed material does not boil at once. gamma_r and K: density and stiffness of the ReleaseLine; P_eq:
  /// pressure of the boiling mixture, 0 below 1250 K; S = t^2 (3 - 2t) rises from 0 where liquid boils at 1 bar to 1
  /// at 27/32 of the critical temperature, from where liquid bears no tension. Temperature and phases in tension are
  /// those of the same energy on the release line, where voids take the material. P is continuous; c^2 jumps only where
  /// a phase begins or ends. doc/theory/equation_of_state.md.
  class SolidLiquidVapour : public EquationOfState, public ThermalModel
  {
  public:
    /// @throws StateError never for the constants built in.
    SolidLiquidVapour();

    void
    evaluate(std::span<const double> true_density, std::span<const double> energy, std::span<double> pressure,
             std::span<double> sound_speed_squared) const override;
    void
    derivatives(std::span<const double> true_density, std::span<const double> energy, std::span<double> dp_ddensity,
                std::span<double> dp_de) const override;
    double
    energy_of_pressure(double true_density, double pressure) const override;
    double
    reference_density() const override;

    /// 3 gamma0, to which the free energies are fitted.
    double
    max_density() const override;

    /// melt_temperature: of the solid of this density, below the melting density that of zero pressure. Fluid below the
    /// critical density is vapour, and beyond the boiling curve all of it.
    void
    evaluate(std::span<const double> density, std::span<const double> energy,
             const ThermalOutput &output) const override;
    double
    specific_heat() const override;

    /// Boiling at 1 bar.
    Transitions
    transitions() const override;
    std::string
    name() const override;

  private:
    enum class Phase
    {
      solid,
      melting,
      fluid,
      boiling,
      tension
    };
    using Value = pointwise::Value;
    struct Thermal
    {
      double temperature, melt_fraction, vapour_fraction;
    };

    /// Whether material that is not in tension is solid, given the temperature it would have as a solid.
    bool
    below_solidus(double true_density, double energy, double temperature) const;
    Phase
    phase(double true_density, double energy) const;
    Value
    value(double true_density, double energy) const;
    Thermal
    thermal(double true_density, double energy) const;
    double
    melt_temperature(double true_density) const;

    aluminium_phases::Melting::Mixture
    melting_mixture(double true_density, double energy) const;

    /// Adds the tension that condensed material bears below the release line.
    void
    add_tension(double true_density, double energy, Value &value) const;

    aluminium_phases::Melting     melting;
    aluminium_phases::Boiling     boiling;
    aluminium_phases::ReleaseLine release;
    HermiteTable                  solidus;                          ///< temperature by density
    double                        weakening_begins, weakening_ends; ///< energies between which tension fades
    double                        one_bar_vapour;                   ///< energy of the vapour of 1 bar
  };
} // namespace whipple
