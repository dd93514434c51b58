// SPDX-License-Identifier: LGPL-2.1-or-later
#include <whipple/error.h>
#include <whipple/study/cost_law.h>

#include <algorithm>
#include <cmath>

namespace whipple
{
  namespace
  {
    /// Cells of an area, and steps that shrink with the cells.
    constexpr double default_exponent = -3;

    /// start + slope * cell steps with the least sum of squared relative errors; start >= 0, slope > 0.
    void
    fit_seconds(const std::vector<CostSample> &samples, CostLaw &law)
    {
      double w = 0, wx = 0, wy = 0, wxx = 0, wxy = 0;
      for (const CostSample &s : samples)
        {
          const double weight = 1. / (s.wall_s * s.wall_s);
          w += weight;
          wx += weight * s.cell_steps;
          wy += weight * s.wall_s;
          wxx += weight * s.cell_steps * s.cell_steps;
          wxy += weight * s.cell_steps * s.wall_s;
        }
      const double determinant = w * wxx - wx * wx;
      if (samples.size() > 1 && determinant > 0)
        {
          law.s_per_cell_step = (w * wxy - wx * wy) / determinant;
          law.start_s         = (wy - law.s_per_cell_step * wx) / w;
          if (law.s_per_cell_step > 0 && law.start_s >= 0)
            return;
        }
      law.start_s         = 0;
      law.s_per_cell_step = wxy / wxx;
    }
  } // namespace

  CostLaw
  fit_cost(std::vector<CostSample> samples)
  {
    if (samples.empty())
      throw Error("no run to learn a cost from");
    std::sort(samples.begin(), samples.end(), [](const CostSample &a, const CostSample &b) { return a.cell < b.cell; });
    CostLaw law;
    if (samples.size() > 1 && samples[1].cell > samples[0].cell)
      law.cell_steps = convergence::fit_power_law(
          {{samples[1].cell, samples[1].cell_steps}, {samples[0].cell, samples[0].cell_steps}});
    else
      law.cell_steps = {samples[0].cell_steps * std::pow(samples[0].cell, -default_exponent), default_exponent};
    fit_seconds(samples, law);
    return law;
  }

  std::optional<double>
  CostForecast::seconds(const std::string &series, double cell) const
  {
    if (const auto own = samples_.find(series); own != samples_.end())
      return fit_cost(own->second).seconds(cell);
    double sum = 0;
    for (const auto &[name, samples] : samples_)
      sum += fit_cost(samples).seconds(cell) / samples_.size();
    return samples_.empty() ? std::nullopt : std::optional<double>(sum);
  }
} // namespace whipple
