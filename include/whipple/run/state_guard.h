// SPDX-License-Identifier: LGPL-2.1-or-later
#pragma once

#include <whipple/ledger/ledger.h>
#include <whipple/material/cold_curve.h>
#include <whipple/run/domain.h>

#include <vector>

namespace whipple
{
  /// Looks for states that must not be, of which the sums of the ledger know nothing (doc/theory/guards.md): energy
  /// below the cold curve, density beyond the law's pole, expanded matter that is stiffer than any solid, what is no
  /// number. Made once a stage; a look costs about a
  /// tenth of a step.
  template <int dim>
  class StateGuard
  {
  public:
    StateGuard(const Scene<dim> &scene, const FieldLayout &layout);

    /// Look at all cells. Energy that lies below the cold curve by more than round-off is noted in the ledger; where
    /// the sum of it is more than a thousandth of the energy of the problem, energy has come from nowhere.
    /// @param energy_scale of the problem, Mbar cm^3
    /// @throws StateError on all ranks, naming material, place and numbers.
    void
    check(const Domain<dim> &domain, double energy_scale, Ledger<dim> &ledger) const;

  private:
    /// What one material's cells lack, over owned cells.
    struct Deficit
    {
      double energy = 0;    ///< sum of M (e_cold - e), Mbar cm^3
      double cells  = 0;    ///< that lack any
      double worst  = 0;    ///< largest M (e_cold - e), Mbar cm^3
      Index  cell   = none; ///< where
    };

    Deficit
    deficit(const Domain<dim> &domain, std::size_t material) const;

    /// Whether a law keeps a pressure that no expansion relieves: the linear polynomial's grows as e, not as gamma e.
    /// @throws StateError if c^2 is above 1000 max(c_0^2, e) below half of the reference density
    void
    check_expansion(const Domain<dim> &domain, std::size_t material, Index cell, double true_density) const;

    const FieldLayout     &layout_;
    std::vector<ColdCurve> curve_;                    ///< of each material, from its coldest body less a margin
    std::vector<double>    cold_sound_speed_squared_; ///< of each material at rest without energy, (cm/us)^2
  };
} // namespace whipple
