// SPDX-License-Identifier: LGPL-2.1-or-later
#pragma once

#include <whipple/material/failure_model.h>
#include <whipple/material/thermal_model.h>

#include <array>
#include <limits>
#include <memory>
#include <optional>

namespace whipple
{
  /// Ductile failure: damage grows by the plastic strain over the strain at failure,
  ///
  ///   dD = d eps_p / eps_f,
  ///   eps_f = [D1 + D2 exp(D3 s)] (1 + D4 ln max(rate/rate0, 1)) (1 + D5 T*),   s = -P / sigma_eq,
  ///
  /// with s up to the largest triaxiality of the fit and eps_f not below a least strain. Beside it, tension of the
  /// solid beyond the spall strength, and voids beyond a threshold where there are any, are failure.
  /// doc/theory/failure.md.
  class JohnsonCookDamage : public FailureModel
  {
  public:
    struct Constants
    {
      std::array<double, 5> d{};                   ///< D1 ... D5
      double                reference_rate = 1e-6; ///< rate0 [1/us], > 0

      double melt_temperature      = 0;    ///< of T* [K], > T_ref; not read for D5 = 0
      double reference_temperature = 300.; ///< T_ref [K], >= 0

      double largest_triaxiality = 1.5;  ///< of s, > 0: where the fit ends
      double least_ductility     = 0.01; ///< of eps_f, > 0

      double spall_strength = std::numeric_limits<double>::infinity(); ///< Mbar, >= 0
      double void_fraction  = 1e-3; ///< phi beyond which the material counts as broken, 0 <= phi < 1
    };

    /// @param thermal  may be null for D5 = 0
    /// @throws InputError for constants outside their ranges, or D5 != 0 without a thermal model.
    JohnsonCookDamage(const Constants &constants, std::shared_ptr<const ThermalModel> thermal);

    void
    advance(const FailureInput &state, std::span<double> damage) const override;
    bool
    needs_strength() const override;
    std::string
    name() const override;

    /// s at which D1 + D2 exp(D3 s) falls to zero, if it does within the range of the fit.
    std::optional<double>
    end_of_ductility() const;
    /// s beyond which eps_f stays what it is there: half of end_of_ductility(), else the constant.
    double
    largest_triaxiality() const
    {
      return largest_triaxiality_;
    }

  private:
    double
    grown(const FailureInput &state, std::size_t i, double homologous, double damage) const;

    Constants                           constants_;
    double                              largest_triaxiality_;
    std::shared_ptr<const ThermalModel> thermal_;
  };
} // namespace whipple
