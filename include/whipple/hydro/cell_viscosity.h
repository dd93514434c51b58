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
    constexpr int       subfaces = FlatMesh<dim>::subfaces;
    const Index         last     = static_cast<Index>(work.mass.size()) - 1;
    std::array<Pack, 2> side{Pack(0.), Pack(0.)};
    if (work.has_neighbours)
      for (int upper = 0; upper < 2; ++upper)
        side[upper] = Pack([&](auto lane) {
          const auto &near = work.neighbours[std::min<Index>(first + static_cast<Index>(lane), last)];
          const int   i    = subfaces * (2 * axis + upper);
          double      sum  = work.stretch_rate[axis][near[i]];
          for (int s = 1; s < subfaces; ++s)
            sum += work.stretch_rate[axis][near[i + s]];
          return (1. / subfaces) * sum;
        });
    return side;
  }

  /// Limited viscosity of both directions; 0 unless the cell loses volume.
  template <int dim>
  inline Pack
  artificial_viscosity(const HydroParameters &parameters, const CornerVectors<dim, Pack> &x,
                       const CornerVectors<dim, Pack> &v, const Pack &divergence, const Pack &density,
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
  inline CornerVectors<dim, Pack>
  tensor_force(const HydroParameters &parameters, const CornerVectors<dim, Pack> &x, const CornerVectors<dim, Pack> &v,
               const VelocityGradient<dim, Pack> &gradient, const HalfStepPack<dim> &half, const Pack &density,
               const Pack &sound_speed, Index first, const StepWork<dim> &work)
  {
    const auto compressed = gradient.divergence() < 0. && density > 0.;
    if (none_of(compressed))
      return {};
    std::array<Pack, dim> psi;
    for (int d = 0; d < dim; ++d)
      {
        const Pack rate    = viscosity::stretch(d, x, v).rate;
        const auto shrinks = rate < -viscosity::smallest_rate;
        const auto side    = neighbour_rates(d, first, work);
        psi[d] = select(shrinks, viscosity::limiter(select(shrinks, rate, Pack(-1.)), side[0], side[1]), Pack(0.));
      }
    const auto               stress = viscosity::tensor_stress(parameters, x, gradient, density, sound_speed, psi);
    CornerVectors<dim, Pack> force;
    for (int k = 0; k < FlatMesh<dim>::corners; ++k)
      {
        const auto pull = stress.on(shape_gradient<dim>(k, half.volume_gradient, half.hoop));
        for (int d = 0; d < dim; ++d)
          force[d][k] = select(compressed, Pack(-pull[d]), Pack(0.));
      }
    return force;
  }

  /// Add viscous forces, scaled with the part of a compression that the materials take.
  /// @param kept the scaled forces, for the energy they turn into heat
  template <int dim>
  inline void
  add_viscous(const CornerVectors<dim, Pack> &viscous, const Pack &part, CornerVectors<dim, Pack> &force,
              CornerVectors<dim, Pack> &kept)
  {
    for (int d = 0; d < dim; ++d)
      for (int k = 0; k < FlatMesh<dim>::corners; ++k)
        {
          kept[d][k] = part * viscous[d][k];
          force[d][k] += kept[d][k];
        }
  }
} // namespace whipple::cell_kernels
