// SPDX-License-Identifier: LGPL-2.1-or-later
#pragma once

#include <whipple/material/bicubic_table.h>
#include <whipple/material/equation_of_state.h>
#include <whipple/material/equation_of_state_table.h>
#include <whipple/material/pointwise.h>
#include <whipple/material/thermal_model.h>

#include <optional>

namespace whipple
{
  /// Equation of state from a table: P_s(gamma, e) = F(gamma, e - e0(gamma)), with e0 the energy of the lowest row at
  /// each density, F a monotone bicubic and e0 a cubic interpolant. Derivatives and c^2 are exactly those of F
  /// and e0, all continuous. Beyond the table F and e0 go on linearly, so that every state has a pressure. F may fall
  /// with e where the table does. With temperatures in the file also a thermal model.
  /// doc/theory/equation_of_state_tables.md.
  class Tabulated : public EquationOfState, public ThermalModel
  {
  public:
    /// @throws InputError as read_equation_of_state_table() does, and as below.
    explicit Tabulated(const std::string &path);

    /// @throws InputError if the state at rest has no real sound speed, or one that no matter has.
    explicit Tabulated(const EquationOfStateTable &table);

    void
    evaluate(std::span<const double> true_density, std::span<const double> energy, std::span<double> pressure,
             std::span<double> sound_speed_squared) const override;
    void
    derivatives(std::span<const double> true_density, std::span<const double> energy, std::span<double> dp_ddensity,
                std::span<double> dp_de) const override;
    /// Where several energies have that pressure, the one nearest to that of the state at rest.
    double
    energy_of_pressure(double true_density, double pressure) const override;
    double
    reference_density() const override;

    bool
    has_temperature() const override
    {
      return temperature_.has_value();
    }

    /// Below the lowest row the temperature is that of the row; beyond the others it goes on linearly. Fractions are
    /// bilinear and level outside; those that the file does not have are 0, a melt temperature infinite. Only where
    /// has_temperature().
    void
    evaluate(std::span<const double> density, std::span<const double> energy,
             const ThermalOutput &output) const override;
    double
    specific_heat() const override;

    /// Energies at which the fractions of the table leave 0 and reach 1 along P_s = 0 (to 1/4096 of the table's range).
    Transitions
    transitions() const override;

    /// How far the table is from being thermodynamically consistent: the largest, over the middles of its cells with
    /// P_s > 0, of |A + B - C| / (|A| + |B| + |C|), where dT/dgamma|_e + (P dT/de - T dP/de) / gamma^2 = 0 (that
    /// 1/T and P/(gamma^2 T) have one potential, the entropy) reads A + B - C = 0.
    struct Inconsistency
    {
      double largest, density, energy, median;
    };
    /// Only where has_temperature().
    Inconsistency
    inconsistency() const;

    std::string
    name() const override;

  private:
    using State = pointwise::Value;

    void
    check_at_rest() const;

    /// @param hint cell that is tried first, and the one found.
    State
    state(double true_density, double energy, BicubicTable::Cell &hint) const;

    /// Bilinear value of an array over (density, heat), level outside.
    double
    bilinear(const std::vector<double> &values, double true_density, double heat) const;

    EquationOfStateTable        table_;
    PiecewiseCubic              lowest_energy_;
    BicubicTable                pressure_;
    std::optional<BicubicTable> temperature_;
  };
} // namespace whipple
