// SPDX-License-Identifier: LGPL-2.1-or-later
#pragma once

#include <whipple/study/convergence.h>

#include <map>
#include <optional>
#include <string>
#include <vector>

namespace whipple
{
  /// What a run on cells of some size has cost.
  struct CostSample
  {
    double cell       = 0; ///< cm
    double cell_steps = 0;
    double wall_s     = 0;
  };

  /// Wall time as a function of the cell size: cell steps = A h^-q, seconds = start + (seconds a cell step) * cell
  /// steps. Cell steps follow a power law where seconds, on coarse cells, are mostly start.
  struct CostLaw
  {
    convergence::PowerLaw cell_steps; ///< exponent -q
    double                start_s         = 0;
    double                s_per_cell_step = 0;

    double
    seconds(double cell) const
    {
      return start_s + s_per_cell_step * cell_steps(cell);
    }
  };

  /// Fit the law: the exponent from the finest two cells (with one, cell steps go with h^-3: two dimensions and the
  /// time step), the seconds by least squares of relative errors with neither part negative.
  /// @throws Error without samples.
  CostLaw
  fit_cost(std::vector<CostSample> samples);

  /// Forecasts of wall times during a study, from the points that are done: of the same series if there are any, else
  /// the mean of what the other series say about that cell size.
  class CostForecast
  {
  public:
    void
    add(const std::string &series, const CostSample &sample)
    {
      samples_[series].push_back(sample);
    }

    /// Seconds; none if nothing is known yet.
    std::optional<double>
    seconds(const std::string &series, double cell) const;

  private:
    std::map<std::string, std::vector<CostSample>> samples_;
  };
} // namespace whipple
