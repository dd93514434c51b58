// SPDX-License-Identifier: LGPL-2.1-or-later
#pragma once

#include <functional>
#include <vector>

namespace whipple::exact
{
  /// How far the first signal from the rim of the gas has come inwards: beyond it a run does not represent the solution
  /// of unbounded gas, whatever the boundary does. dr/dt = u - c from the rim at the start, by the midpoint rule.
  class RimSignal
  {
  public:
    /// @param inward u - c at (r, t), cm/us
    /// @param rim    radius of the rim at `start`, cm; infinite: there is none, and no signal
    /// @param step   of the table, us; it ends after 10000 steps or when the signal arrives at r = `innermost`(t)
    RimSignal(const std::function<double(double, double)> &inward, double rim, double start, double step,
              const std::function<double(double)> &innermost);

    /// Whether the signal has not come to a radius yet; false after the table's end.
    bool
    not_yet_at(double radius, double time) const;

  private:
    double              start, step;
    std::vector<double> radius; ///< at start + i * step; empty without rim
  };
} // namespace whipple::exact
