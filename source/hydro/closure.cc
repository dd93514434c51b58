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

    /// Volume of a part after a change of pressure, V exp(-y) with y = change / K. Beyond y = 1 its modulus grows with
    /// the pressure, as that of a gas at fixed energy: V / (e y). Convex, with a continuous slope.
    struct Squeezed
    {
      double volume;
      double slope; ///< d volume / d change
    };

    Squeezed
    squeezed(const Part &part, double change)
    {
      const double y = change / part.modulus, v = part.volume * std::exp(-std::min(y, 1.));
      return y <= 1. ? Squeezed{v, -v / part.modulus} : Squeezed{v / y, -v / (y * change)};
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

      // Newton for the sum of squeezed volumes; it is convex and falls, so that x rises monotonically to a root above,
      // and from the second iterate on also to one below
      double x = 0;
      for (int iteration = 0; iteration < 100; ++iteration)
        {
          double sum = 0, slope = 0;
          for (const Part &p : part)
            {
              const Squeezed now = squeezed(p, x);
              sum += now.volume;
              slope += now.slope;
            }
          const double step = (target - sum) / slope;
          x += std::max(step, -softest);
          if (std::abs(step) <= 1e-15 * softest || std::abs(sum - target) <= 1e-15 * target)
            break;
        }
      double sum = 0;
      for (std::size_t m = 0; m < part.size(); ++m)
        sum += result[m] = squeezed(part[m], x).volume;
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
