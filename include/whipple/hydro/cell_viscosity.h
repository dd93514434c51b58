// SPDX-License-Identifier: LGPL-2.1-or-later
#pragma once

#include <whipple/hydro/step_work.h>
#include <whipple/hydro/tensor_viscosity.h>
#include <whipple/hydro/viscosity.h>

/// The kinds of artificial viscosity for a pack of cells, with their neighbours. Equations: doc/theory/viscosity.md.
namespace whipple::cell_kernels
{
  /// Rates of stretch along an axis of the neighbours across the two sides normal to it, 1/us.
  template <int dim>
  inline std::array<Pack, 2>
  neighbour_rates(int axis, Index first, const StepWork<dim> &work)
  {
    const Index         last = static_cast<Index>(work.mass.size()) - 1;
    std::array<Pack, 2> side{Pack(0.), Pack(0.)};
    if (work.has_neighbours)
      for (int upper = 0; upper < 2; ++upper)
        side[upper] = Pack([&](auto lane) {
          const auto &near = work.neighbours[std::min<Index>(first + static_cast<Index>(lane), last)];
          const int   i    = 4 * axis + 2 * upper;
          return 0.5 * (work.stretch_rate[axis][near[i]] + work.stretch_rate[axis][near[i + 1]]);
        });
    return side;
  }

  /// Limited viscosity of both directions; 0 unless the cell loses volume.
  template <int dim>
  inline Pack
  artificial_viscosity(const HydroParameters &parameters, const geometry::QuadOf<Pack> &x,
                       const geometry::QuadOf<Pack> &v, const Pack &divergence, const Pack &density,
                       const Pack &sound_speed, Index first, const StepWork<dim> &work)
  {
    const auto compressed = divergence < 0. && density > 0.;
    if (none_of(compressed))
      return Pack(0.);
    viscosity::Jumps<Pack> jumps;
    for (int d = 0; d < dim; ++d)
      {
        const std::array<Pack, 2> side = neighbour_rates(d, first, work);
        jumps.add(viscosity::stretch(d, x, v), side[0], side[1]);
      }
    jumps.raise_to(viscosity::thin_jump(x, v));
    return select(compressed, jumps.pressure(parameters, density, sound_speed), Pack(0.));
  }

  /// Forces of the viscous stress; 0 unless the cell loses volume.
  template <int dim>
  inline geometry::QuadOf<Pack>
  tensor_force(const HydroParameters &parameters, const geometry::QuadOf<Pack> &x, const geometry::QuadOf<Pack> &v,
               const VelocityGradient<Pack> &gradient, const HalfStepPack &half, const Pack &density,
               const Pack &sound_speed, Index first, const StepWork<dim> &work)
  {
    const auto compressed = gradient.divergence() < 0. && density > 0.;
    if (none_of(compressed))
      return {};
    std::array<Pack, 2> psi;
    for (int d = 0; d < dim; ++d)
      {
        const Pack rate    = viscosity::stretch(d, x, v).rate;
        const auto shrinks = rate < -viscosity::smallest_rate;
        const auto side    = neighbour_rates(d, first, work);
        psi[d] = select(shrinks, viscosity::limiter(select(shrinks, rate, Pack(-1.)), side[0], side[1]), Pack(0.));
      }
    const auto             stress = viscosity::tensor_stress(parameters, x, gradient, density, sound_speed, psi);
    geometry::QuadOf<Pack> force;
    for (int k = 0; k < 4; ++k)
      {
        const Pack g0 = half.volume_gradient[0][k] - half.hoop[k], g1 = half.volume_gradient[1][k];
        force[0][k] = select(compressed, Pack(-(stress.s00 * g0 + stress.s01 * g1)), Pack(0.));
        force[1][k] = select(compressed, Pack(-(stress.s01 * g0 + stress.s11 * g1)), Pack(0.));
      }
    return force;
  }

  /// Add viscous forces, scaled with the part of a compression that the materials take.
  /// @param kept the scaled forces, for the energy they turn into heat
  inline void
  add_viscous(const geometry::QuadOf<Pack> &viscous, const Pack &part, geometry::QuadOf<Pack> &force,
              geometry::QuadOf<Pack> &kept)
  {
    for (int d = 0; d < 2; ++d)
      for (int k = 0; k < 4; ++k)
        {
          kept[d][k] = part * viscous[d][k];
          force[d][k] += kept[d][k];
        }
  }
} // namespace whipple::cell_kernels
