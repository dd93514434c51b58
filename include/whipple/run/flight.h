// SPDX-License-Identifier: LGPL-2.1-or-later
#pragma once

#include <whipple/run/domain.h>

#include <cstdint>
#include <memory>
#include <vector>

namespace whipple
{
  /// Fragments in free flight, set aside while the others are stepped: the domain holds those others only, on a view of
  /// their own, until land() puts all together again. Dropped without land(), all there was is what the last good state
  /// holds.
  template <int dim>
  class Flight
  {
  public:
    /// Collective.
    /// @param flies of owned cells, a flag each (flying_cells); all cells have nodes of their own and there is no halo
    /// @param domain out: what is left to step
    Flight(const FieldLayout &layout, const std::vector<std::uint8_t> &flies, Domain<dim> &domain);

    /// What is in flight, all ranks. Free flight does not change it.
    const ConservedTotals<dim> &
    totals() const
    {
      return totals_;
    }

    /// Move what is in flight to the time of the domain, and put it back beside what has been stepped.
    void
    land(Domain<dim> &domain);

  private:
    std::shared_ptr<const FlatPartition<dim>> view_;       ///< of all
    State<dim>                                state_;      ///< of all, as it was
    std::vector<Index>                        of_stepped_; ///< cell of view_ of each owned cell that is stepped
    ConservedTotals<dim>                      totals_;
  };
} // namespace whipple
