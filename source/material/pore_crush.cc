// SPDX-License-Identifier: LGPL-2.1-or-later
#include <whipple/material/pore_crush.h>

#include <algorithm>
#include <array>
#include <cstdint>
#include <limits>

namespace whipple
{
  namespace
  {
    /// Newton needs 3 to 6.
    constexpr int max_iterations = 200;

    using Block = std::array<double, crush_block_length>;

    std::span<double>
    first(Block &block, std::size_t n)
    {
      return std::span<double>(block).first(n);
    }

    /// The cells of a block that crush, packed. Unknown: x, with f(x) = P_s(alpha rho, e) / alpha - P(x) = 0.
    struct CrushingCells
    {
      std::size_t                                  count = 0;
      std::array<std::size_t, crush_block_length>  cell;
      Block                                        rho, energy;
      Block                                        x, lower, upper; // the iterate and its bracket
      Block                                        true_density, pressure;
      std::array<std::int64_t, crush_block_length> done; // 1: x is final; as wide as a double, for vector code
    };

    /// Cells above the crush curve. Those that lose all their pores are set here and not gathered.
    void
    gather(const EquationOfState &eos, const CrushCurve &curve, std::span<const double> rho,
           std::span<const double> energy, std::span<const double> pressure, std::span<double> phi,
           CrushingCells &crushing)
    {
      const double limit = largest_trial_density(eos);
      crushing.count     = 0;
      for (std::size_t i = 0; i < rho.size(); ++i)
        {
          if (!(rho[i] > 0. && curve.crushes(phi[i], pressure[i])))
            continue;
          const std::size_t k = crushing.count++;
          crushing.cell[k]    = i;
          crushing.rho[k]     = rho[i];
          crushing.energy[k]  = energy[i];
          crushing.upper[k]   = curve.place(phi[i]);
        }
      const std::size_t n = crushing.count;
      if (n == 0)
        return;

      Block closed, sound_speed_squared;
      for (std::size_t k = 0; k < n; ++k)
        crushing.true_density[k] = std::min(crushing.rho[k], limit);
      eos.evaluate(first(crushing.true_density, n), first(crushing.energy, n), first(closed, n),
                   first(sound_speed_squared, n));
      std::size_t kept = 0;
      for (std::size_t k = 0; k < n; ++k)
        {
          if (crushing.rho[k] >= limit || closed[k] >= curve.closed)
            {
              phi[crushing.cell[k]] = 0.;
              continue;
            }
          // Not beyond the pole, where P_s means nothing: it is above the curve just below the pole already.
          const double pole     = std::sqrt((limit / crushing.rho[k] - 1.) / curve.distension);
          crushing.cell[kept]   = crushing.cell[k];
          crushing.rho[kept]    = crushing.rho[k];
          crushing.energy[kept] = crushing.energy[k];
          crushing.lower[kept]  = 0.;
          crushing.upper[kept]  = std::min(crushing.upper[k], pole);
          crushing.x[kept]      = crushing.upper[kept];
          crushing.done[kept++] = 0;
        }
      crushing.count = kept;
    }

    /// One safeguarded Newton step in every cell that is not done; all choices are selections, so that the loop
    /// vectorises, and cells that are done keep their x.
    /// @returns how many are done.
    std::size_t
    newton_step(const CrushCurve &curve, const Block &dp_ddensity, CrushingCells &crushing)
    {
      constexpr double rounding  = 2. * std::numeric_limits<double>::epsilon();
      constexpr double quadratic = 1e-9; // after a Newton step this small, what is left is below rounding
      std::int64_t     n_done    = 0;
      for (std::size_t k = 0; k < crushing.count; ++k)
        {
          const double x        = crushing.x[k];
          const double alpha    = 1. + curve.distension * x * x;
          const double bulk     = crushing.pressure[k] / alpha;
          const double residual = bulk - curve.pressure(x);
          const double slope =
              (crushing.rho[k] * dp_ddensity[k] - bulk) / alpha * (2. * curve.distension * x) + curve.fall;
          const double newton  = x - residual / slope;
          const double lower   = residual < 0. ? x : crushing.lower[k];
          const double upper   = residual < 0. ? crushing.upper[k] : x;
          const bool   inside  = (newton > lower) & (newton < upper);
          const double next    = inside ? newton : 0.5 * (lower + upper);
          const double change  = inside ? std::abs(newton - x) : upper - lower;
          const double enough  = inside ? quadratic * x : rounding;
          const bool   settled = (crushing.done[k] != 0) | (std::abs(newton - x) <= rounding * x);
          crushing.lower[k]    = lower;
          crushing.upper[k]    = upper;
          crushing.x[k]        = settled ? x : next;
          crushing.done[k]     = settled | (change <= enough) ? 1 : 0;
          n_done += crushing.done[k];
        }
      return static_cast<std::size_t>(n_done);
    }

    void
    solve(const EquationOfState &eos, const CrushCurve &curve, std::span<double> phi, CrushingCells &crushing)
    {
      const std::size_t n = crushing.count;
      Block             dp_ddensity, dp_de, sound_speed_squared;
      std::size_t       done = 0;
      for (int iteration = 0; iteration < max_iterations && done < n; ++iteration)
        {
          for (std::size_t k = 0; k < n; ++k)
            crushing.true_density[k] = (1. + curve.distension * crushing.x[k] * crushing.x[k]) * crushing.rho[k];
          eos.evaluate(first(crushing.true_density, n), first(crushing.energy, n), first(crushing.pressure, n),
                       first(sound_speed_squared, n));
          eos.derivatives(first(crushing.true_density, n), first(crushing.energy, n), first(dp_ddensity, n),
                          first(dp_de, n));
          done = newton_step(curve, dp_ddensity, crushing);
        }
      // A state that is not a number is not done; it keeps the phi it had.
      for (std::size_t k = 0; k < n; ++k)
        if (crushing.done[k] != 0)
          {
            const double pores  = curve.distension * crushing.x[k] * crushing.x[k];
            double      &phi_of = phi[crushing.cell[k]];
            phi_of              = std::min(phi_of, pores / (1. + pores));
          }
    }

  } // namespace

  void
  crush_pores(const EquationOfState &eos, const CrushCurve &curve, std::span<const double> bulk_density,
              std::span<const double> energy, std::span<const double> solid_pressure, std::span<double> void_fraction)
  {
    CrushingCells crushing;
    gather(eos, curve, bulk_density, energy, solid_pressure, void_fraction, crushing);
    solve(eos, curve, void_fraction, crushing);
  }
} // namespace whipple
