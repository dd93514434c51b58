// SPDX-License-Identifier: LGPL-2.1-or-later

#include <whipple/hydro/closure.h>

#include <algorithm>
#include <cmath>

namespace whipple::closure
{
  namespace
  {
    double
    sum_of_volumes(std::span<const Part> part)
    {
      double sum = 0;
      for (const Part &p : part)
        sum += p.volume;
      return sum;
    }

    /// Bring the sum of volumes to `target` by equal strain.
    void
    share_equally(std::span<const Part> part, double target, std::span<double> result)
    {
      const double ratio = target / sum_of_volumes(part);
      for (std::size_t m = 0; m < part.size(); ++m)
        result[m] = part[m].volume * ratio;
    }

    /// Bring the sum of volumes to `target` by the same pressure change in all.
    void
    share_by_compressibility(std::span<const Part> part, double target, std::span<double> result)
    {
      double softest = part[0].modulus;
      for (const Part &p : part)
        softest = std::min(softest, p.modulus);
      if (part.size() == 1 || !(softest > 0) || !(target > 0))
        return share_equally(part, target, result);

      // Newton for sum V_m exp(-x / K_m) = target; the left side is convex and falls, so from the second
      // iterate on x rises monotonically to the root
      double x = 0;
      for (int iteration = 0; iteration < 50; ++iteration)
        {
          double sum = 0, slope = 0;
          for (const Part &p : part)
            {
              const double v = p.volume * std::exp(-x / p.modulus);
              sum += v;
              slope -= v / p.modulus;
            }
          const double step = (target - sum) / slope;
          x += std::clamp(step, -softest, softest);
          if (std::abs(step) <= 1e-15 * softest || std::abs(sum - target) <= 1e-15 * target)
            break;
        }
      double sum = 0;
      for (std::size_t m = 0; m < part.size(); ++m)
        sum += result[m] = part[m].volume * std::exp(-x / part[m].modulus);
      for (double &v : result.first(part.size()))
        v *= target / sum;
    }
  } // namespace

  void
  share_volume(double cell_volume, double new_cell_volume, std::span<const Part> part, std::span<double> result)
  {
    const double material  = sum_of_volumes(part);
    const double open_void = cell_volume - material;
    if (open_void <= closed_share * cell_volume)
      share_by_compressibility(part, new_cell_volume, result);
    else if (new_cell_volume < cell_volume)
      {
        double load = 0; // sum V_m P_m
        for (const Part &p : part)
          load += p.volume * p.pressure;
        const double loss  = cell_volume - new_cell_volume;
        const double share = compressed_share(material / cell_volume, loss / cell_volume, load > 0);
        share_by_compressibility(part, std::min(material - share * loss, new_cell_volume), result);
      }
    else
      for (std::size_t m = 0; m < part.size(); ++m)
        result[m] =
            part[m].pressure > part[m].loose ? part[m].volume * (new_cell_volume / cell_volume) : part[m].volume;
  }
} // namespace whipple::closure
