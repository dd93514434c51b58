// SPDX-License-Identifier: LGPL-2.1-or-later
#include <whipple/material/void_relaxation.h>

#include <algorithm>
#include <array>
#include <cmath>
#include <cstddef>
#include <cstdint>
#include <limits>

namespace whipple
{
  namespace
  {
    /// Cells are taken in blocks that fit the first-level cache; nothing is allocated.
    constexpr std::size_t block_length = 256;

    /// Largest phi below 1 that a double can hold.
    constexpr double largest_void_fraction = 1. - 0.5 * std::numeric_limits<double>::epsilon();

    /// Newton needs 3 to 6; bisection alone, from the widest bracket there is, about 110.
    constexpr int max_iterations = 200;

    using Block = std::array<double, block_length>;

    /// The cells of a block whose voids may change, packed. The unknown is the true density gamma, in which
    /// the equation is nearly linear: with R = gamma0^2 / (alpha dt), phi(gamma) = 1 - rho/gamma,
    ///   h(gamma) = (R / rho) (phi - phi_old) + P_s = R (gamma - gamma_old) / (gamma gamma_old) + P_s = 0.
    struct OpenCells
    {
      std::size_t                            count = 0;
      std::array<std::size_t, block_length>  cell;
      Block                                  rho, energy, phi_old, true_density_old;
      Block                                  true_density, lower, upper; // the iterate and its bracket
      Block                                  pressure;
      std::array<std::int64_t, block_length> done; // 1: gamma is final; as wide as a double, for vector code

      void
      move(std::size_t from, std::size_t to)
      {
        cell[to]             = cell[from];
        rho[to]              = rho[from];
        energy[to]           = energy[from];
        phi_old[to]          = phi_old[from];
        true_density_old[to] = true_density_old[from];
        true_density[to]     = true_density[from];
        lower[to]            = lower[from];
        upper[to]            = upper[from];
        pressure[to]         = pressure[from];
        done[to]             = done[from];
      }

      /// Drop the cells for which keep(k) is false; the others keep their order.
      template <class Keep>
      void
      filter(const Keep &keep)
      {
        std::size_t kept = 0;
        for (std::size_t k = 0; k < count; ++k)
          if (keep(k))
            {
              if (kept != k)
                move(k, kept);
              ++kept;
            }
        count = kept;
      }
    };

    std::span<double>
    first(Block &block, std::size_t n)
    {
      return std::span<double>(block).first(n);
    }

    /// Trial densities are kept below the pole of the law.
    double
    largest_density(const EquationOfState &eos)
    {
      constexpr double below_pole = 1. - 1e-6;
      return below_pole * eos.max_density();
    }

    /// Cells that have, or may open, voids. Vector test first: a block of sound material ends there.
    /// @param threshold of a cell: the pressure of the solid below which it opens.
    template <class Threshold>
    void
    gather(const EquationOfState &eos, const Threshold &threshold, std::span<const double> rho,
           std::span<const double> energy, std::span<const double> phi, OpenCells &open)
    {
      const std::size_t n                 = rho.size();
      const double      reference_density = eos.reference_density();
      const double      limit             = largest_density(eos);

      Block true_density, pressure, sound_speed_squared;
      for (std::size_t i = 0; i < n; ++i)
        {
          const double g  = rho[i] / (1. - phi[i]);
          true_density[i] = rho[i] > 0. ? std::min(g, limit) : reference_density;
        }
      eos.evaluate(first(true_density, n), energy, first(pressure, n), first(sound_speed_squared, n));

      long may_change = 0;
      for (std::size_t i = 0; i < n; ++i)
        may_change += static_cast<long>((rho[i] > 0.) & ((phi[i] > 0.) | (pressure[i] < threshold(i))));

      open.count = 0;
      if (may_change == 0)
        return;
      for (std::size_t i = 0; i < n; ++i)
        if (rho[i] > 0. && (phi[i] > 0. || pressure[i] < threshold(i)))
          {
            const std::size_t k      = open.count++;
            open.cell[k]             = i;
            open.rho[k]              = rho[i];
            open.energy[k]           = energy[i];
            open.phi_old[k]          = phi[i];
            open.true_density_old[k] = rho[i] / (1. - phi[i]);
            open.true_density[k]     = true_density[i];
            open.pressure[k]         = pressure[i];
          }
    }

    /// Close the voids that do not survive the step, set the bracket of the others; cells in balance, or
    /// whose pressure is not a number, are dropped as they are.
    void
    bracket(const EquationOfState &eos, double resistance, std::span<double> phi, OpenCells &open)
    {
      Block pressure_closed, sound_speed_squared;
      eos.evaluate(first(open.rho, open.count), first(open.energy, open.count), first(pressure_closed, open.count),
                   first(sound_speed_squared, open.count));
      const double limit = largest_density(eos);
      open.filter([&](std::size_t k) {
        open.done[k] = 0;
        if (open.pressure[k] > 0.)
          {
            if (open.rho[k] >= limit || pressure_closed[k] * open.rho[k] >= resistance * open.phi_old[k])
              {
                phi[open.cell[k]] = 0.;
                return false;
              }
            open.lower[k] = open.rho[k];
            open.upper[k] = open.true_density[k];
            return true;
          }
        open.lower[k] = open.true_density[k];
        open.upper[k] = std::min(limit, open.rho[k] / (1. - largest_void_fraction));
        return open.pressure[k] < 0. && open.lower[k] < open.upper[k];
      });
    }

    /// One safeguarded Newton step in every cell that is not done; all choices are selections, so that the loop
    /// vectorises, and cells that are done keep their gamma.
    /// @returns how many are done.
    std::size_t
    newton_step(double resistance, const Block &dp_ddensity, OpenCells &open)
    {
      constexpr double rounding  = 2. * std::numeric_limits<double>::epsilon();
      constexpr double quadratic = 1e-9; // after a Newton step this small, what is left is below rounding
      std::int64_t     n_done    = 0;
      for (std::size_t k = 0; k < open.count; ++k)
        {
          const double true_density = open.true_density[k];
          const double residual =
              resistance * (true_density - open.true_density_old[k]) / (true_density * open.true_density_old[k]) +
              open.pressure[k];
          const double slope  = resistance / (true_density * true_density) + dp_ddensity[k];
          const double newton = true_density - residual / slope;
          const double change = std::abs(newton - true_density);
          const double lower  = residual < 0. ? true_density : open.lower[k];
          const double upper  = residual < 0. ? open.upper[k] : true_density;
          const bool   inside = (newton > lower) & (newton < upper);
          const double next   = inside ? newton : 0.5 * (lower + upper);
          // Distance still to go, against what may be left of it.
          const double distance = inside ? change : upper - lower;
          const double enough   = inside ? quadratic * true_density : rounding * upper;
          const bool   settled  = (open.done[k] != 0) | (change <= rounding * true_density);
          open.lower[k]         = lower;
          open.upper[k]         = upper;
          open.true_density[k]  = settled ? true_density : next;
          open.done[k]          = settled | (distance <= enough) ? 1 : 0;
          n_done += open.done[k];
        }
      return static_cast<std::size_t>(n_done);
    }

    /// Write phi of the cells that are done and drop them.
    void
    retire(std::span<double> phi, OpenCells &open)
    {
      Block result;
      for (std::size_t k = 0; k < open.count; ++k)
        {
          // As an increment: exact where phi hardly moves, and its sign is that of -P_s.
          const double change = open.rho[k] * ((open.true_density[k] - open.true_density_old[k]) /
                                               (open.true_density[k] * open.true_density_old[k]));
          result[k]           = std::clamp(open.phi_old[k] + change, 0., largest_void_fraction);
        }
      open.filter([&](std::size_t k) {
        if (open.done[k] != 0)
          phi[open.cell[k]] = result[k];
        return open.done[k] == 0;
      });
    }

    void
    solve(const EquationOfState &eos, double resistance, std::span<double> phi, OpenCells &open)
    {
      Block dp_ddensity, dp_de, sound_speed_squared;
      for (int iteration = 0; iteration < max_iterations && open.count > 0; ++iteration)
        {
          const std::size_t n = open.count;
          eos.derivatives(first(open.true_density, n), first(open.energy, n), first(dp_ddensity, n), first(dp_de, n));
          if (iteration > 0)
            eos.evaluate(first(open.true_density, n), first(open.energy, n), first(open.pressure, n),
                         first(sound_speed_squared, n));
          // Packing costs more than to carry a few finished cells along.
          if (2 * newton_step(resistance, dp_ddensity, open) >= n)
            retire(phi, open);
        }
      // Only a state that is not a number gets here unfinished; it keeps the phi it had.
    }
  } // namespace

  void
  relax_void_fraction(const EquationOfState &eos, double alpha_dt, double spall_strength, const VoidInput &state,
                      std::span<double> void_fraction)
  {
    const double reference_density = eos.reference_density();
    const double resistance        = reference_density * reference_density / alpha_dt;
    if (!std::isfinite(resistance)) // alpha dt = 0: voids stay as they are
      return;

    OpenCells open;
    for (std::size_t start = 0; start < state.bulk_density.size(); start += block_length)
      {
        const std::size_t n      = std::min(block_length, state.bulk_density.size() - start);
        const auto        phi    = void_fraction.subspan(start, n);
        const auto        rho    = state.bulk_density.subspan(start, n);
        const auto        energy = state.energy.subspan(start, n);
        if (state.soundness.empty())
          gather(
              eos, [negative = -spall_strength](std::size_t) { return negative; }, rho, energy, phi, open);
        else
          gather(
              eos,
              [spall_strength, soundness = state.soundness.subspan(start, n)](std::size_t i) {
                return opening_pressure(spall_strength, soundness[i]);
              },
              rho, energy, phi, open);
        if (open.count == 0)
          continue;
        bracket(eos, resistance, phi, open);
        solve(eos, resistance, phi, open);
      }
  }
} // namespace whipple
