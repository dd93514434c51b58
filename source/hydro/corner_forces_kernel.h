// SPDX-License-Identifier: LGPL-2.1-or-later
#pragma once

#include <whipple/hydro/cell_kernels.h>
#include <whipple/hydro/cell_viscosity.h>
#include <whipple/hydro/closure.h>
#include <whipple/hydro/deviator.h>
#include <whipple/hydro/hourglass.h>
#include <whipple/hydro/trace.h>
#include <whipple/hydro/velocity_gradient.h>

/// The force pass over the cells, for one kind of artificial viscosity. Each kind has its own source file, which
/// includes this one: all in one, the compiler stops inlining and every kind pays (some 10 % of a step).
namespace whipple::cell_kernels
{
  namespace
  {
    /// Volume-weighted means over the materials of a pack of cells at half step.
    template <int dim>
    struct MeanState
    {
      Pack                pressure    = 0.; ///< sum f P, Mbar
      Pack                sound_speed = 0.; ///< mass-weighted, cm/us
      Deviator<dim, Pack> stress      = Deviator<dim, Pack>::zero();
    };

    /// How a pack of cells is filled.
    struct Filling
    {
      Pack::mask_type open;       ///< holds open void
      Pack            modulus;    ///< what a full cell answers volume change with, V / sum(V_m / K_m), Mbar
      Pack            compressed; ///< part of a compression that the materials of a cell with open void take
      Pack            occupied;   ///< sum V_m / V
    };

    template <int dim>
    Filling
    filling(const State<dim> &state, const Derived &derived, const Pack &volume, const Pack &strain,
            const StepWork<dim> &work, Index first)
    {
      Pack occupied(0.), compliance(0.), pressed(0.);
      for (std::size_t m = 0; m < state.material.size(); ++m)
        {
          const MaterialState &material = state.material[m];
          const Pack           v = load(material.volume, first), c = load(derived.material[m].sound_speed, first);
          const Pack           modulus = load(material.density, first) * c * c;
          occupied += v;
          pressed += v * load(derived.material[m].pressure, first);
          compliance += select(trace::has_state(material, work.material[m], volume, first), v / modulus, Pack(0.));
        }
      const Pack filled = occupied / volume;
      return {volume - occupied > closure::closed_share * volume,
              select(compliance > 0., occupied / compliance, Pack(0.)),
              select(strain > 0., closure::compressed_share(filled, strain, pressed > 0.), Pack(0.)), filled};
    }

    /// Half-step pressure of one material. Pores give way before the material does: where they are open the change of
    /// pressure is scaled with 1 / (1 + lambda dt/2), lambda = A gamma^2 c^2 (VoidLaw::yielding()). Were it left out
    /// where the law is too slow for the step, an explicit Euler step would pump its oscillation. Beside open void a
    /// material carries no tension
    /// (`least`, 0 without strength: with it the stress across the surface vanishes, not the pressure),
    /// and of a compression it takes part only as far as closure::compressed_share() says; its pressure on the nodes is
    /// scaled with that, so that the work done on it belongs to the change of its volume (a trace in a cell that keeps
    /// closing would otherwise be heated without bound).
    Pack
    half_pressure(const MaterialState &material, const DerivedMaterial &derived, double yielding, const Filling &fill,
                  const Pack &expansion, const Pack &least, double half_dt, Index first)
    {
      const Pack pressure = load(derived.pressure, first);
      const Pack c = load(derived.sound_speed, first), density = load(material.density, first),
                 modulus    = density * c * c;
      const auto compressed = expansion < 0. && fill.occupied > 0.;
      const Pack part       = select(compressed && fill.open, Pack(fill.compressed / fill.occupied), Pack(1.));
      Pack       kept(1.); // of the change of pressure
      if (material.has_voids() && yielding > 0)
        {
          const Pack phi = load(material.void_fraction, first), true_density = density / (1. - phi);
          kept = select(phi > 0., 1. / (1. + half_dt * yielding * (true_density * true_density * c * c)), kept);
        }
      const Pack full  = pressure - kept * (fill.modulus * expansion);
      const Pack loose = pressure - kept * (modulus * (part * expansion));
      return select(fill.open, Pack(part * max(loose, least)), full);
    }

    /// (1 - phi) times the least principal deviator: the pressure of solid across whose surface nothing presses, Mbar.
    template <int dim>
    Pack
    least_pressure(const State<dim> &state, const MaterialState &material, Index first)
    {
      Pack least = StoredDeviator<dim>(material, state.index).load(first).least_principal();
      if (material.has_voids())
        least *= 1. - load(material.void_fraction, first);
      return least;
    }

    /// Half-step deviator of one material.
    template <int dim>
    Deviator<dim, Pack>
    half_stress(const State<dim> &state, const MaterialState &material, const DerivedMaterial &derived,
                const DeformationRate<dim, Pack> &rate, double half_dt, Index first)
    {
      const Deviator<dim, Pack> trial = elastic_trial(StoredDeviator<dim>(material, state.index).load(first), rate,
                                                      load(derived.shear_modulus, first), half_dt);
      return returned(trial, trial.equivalent(), load(derived.yield_stress, first));
    }

    template <bool strength, int dim>
    MeanState<dim>
    mean_state(const State<dim> &state, const Derived &derived, const VelocityGradient<dim, Pack> &gradient,
               const Filling &fill, double dt, Index first, StepWork<dim> &work)
    {
      const Pack                       volume    = load(state.volume, first);
      const Pack                       expansion = 0.5 * dt * gradient.divergence();
      const DeformationRate<dim, Pack> rate(gradient);
      MeanState<dim>                   mean;
      for (std::size_t m = 0; m < state.material.size(); ++m)
        {
          const MaterialState   &material = state.material[m];
          const DerivedMaterial &from     = derived.material[m];
          const auto             felt     = trace::has_state(material, work.material[m], volume, first);
          if (none_of(felt))
            {
              if (!work.material[m].half_pressure.empty())
                store(Pack(0.), work.material[m].half_pressure, first);
              continue;
            }
          const Pack share = select(felt, Pack(load(material.volume, first) / volume), Pack(0.));
          Pack       least(0.);
          if constexpr (strength)
            if (!from.shear_modulus.empty() && any_of(fill.open))
              least = least_pressure(state, material, first);
          const Pack pressure = select(
              felt, half_pressure(material, from, work.material[m].yielding, fill, expansion, least, 0.5 * dt, first),
              Pack(0.));
          if (!work.material[m].half_pressure.empty())
            store(pressure, work.material[m].half_pressure, first);
          mean.pressure += share * pressure;
          mean.sound_speed += load(material.mass, first) * load(from.sound_speed, first);
          if constexpr (strength)
            if (!from.shear_modulus.empty())
              {
                const auto s     = half_stress(state, material, from, rate, 0.5 * dt, first);
                Pack       solid = share;
                if (material.has_voids())
                  solid *= 1. - load(material.void_fraction, first);
                mean.stress = add_scaled(mean.stress, solid, s);
              }
        }
      const Pack mass  = load(work.mass, first);
      mean.sound_speed = select(mass > 0., mean.sound_speed / mass, Pack(0.));
      return mean;
    }

    /// Write the forces of the corners of a pack of cells.
    template <int dim>
    void
    store_forces(const CornerVectors<dim, Pack> &force, Index first, StepWork<dim> &work)
    {
      const Index end = std::min<Index>(static_cast<Index>(work.mass.size()), first + pack_size);
      for (Index cell = first; cell < end; ++cell)
        for (int k = 0; k < FlatMesh<dim>::corners; ++k)
          for (int d = 0; d < dim; ++d)
            work.corner_force[(cell * FlatMesh<dim>::corners + k) * dim + d] = force[d][k][cell - first];
    }

    template <Symmetry symmetry, bool strength, ViscosityKind kind, int dim>
    void
    corner_forces_of(const FlatMesh<dim> &mesh, const State<dim> &state, const Derived &derived,
                     const HydroParameters &parameters, double dt, StepWork<dim> &work)
    {
      using Cell = CellGeometry<dim, symmetry>;
      for (Index first = 0, pack = 0; first < mesh.n_cells; first += pack_size, ++pack)
        {
          const CornerVectors<dim, Pack> x = gather_corners(mesh, work.half_position, first);
          const CornerVectors<dim, Pack> v = gather_corners(mesh, state.velocity, first);

          HalfStepPack<dim> &half = work.half_step[pack];
          half.volume_gradient    = Cell::volume_gradient(x);
          half.hoop               = Cell::hoop_weight(x);
          half.volume             = Cell::volume(x);
          for (int d = 0; d < dim; ++d)
            half.hourglass_shape[d] = hourglass::moment(x[d]);

          const auto           gradient = velocity_gradient<dim>(half.volume_gradient, half.hoop, half.volume, v);
          const Pack           strain   = -dt * gradient.divergence();
          const Filling        fill     = filling(state, derived, load(state.volume, first), strain, work, first);
          const MeanState<dim> mean     = mean_state<strength>(state, derived, gradient, fill, dt, first, work);
          const Pack           mass = load(work.mass, first), inverse = 1. / half.volume;
          if constexpr (kind == ViscosityKind::scalar)
            {
              half.viscosity = artificial_viscosity(parameters, x, v, gradient.divergence(), Pack(mass * inverse),
                                                    mean.sound_speed, first, work);
              half.viscosity *= select(fill.open, fill.compressed, Pack(1.));
            }
          else
            half.viscosity = 0.;

          const Pack resistance =
              select(mass > 0.,
                     0.25 * parameters.hourglass * mass * mean.sound_speed / Cell::mean_extent(half.volume, half.hoop),
                     Pack(0.));
          half.hourglass_drag = hourglass::velocity(half.hourglass_shape, gradient, v);
          for (Pack &drag : half.hourglass_drag)
            drag *= resistance;

          const Pack               pressure = mean.pressure + half.viscosity;
          CornerVectors<dim, Pack> force;
          for (int k = 0; k < FlatMesh<dim>::corners; ++k)
            {
              const std::array<Pack, dim> g     = shape_gradient<dim>(k, half.volume_gradient, half.hoop);
              const Pack                  gamma = hourglass::shape_vector(k, half.hourglass_shape, g, inverse);
              for (int d = 0; d < dim; ++d)
                force[d][k] = pressure * half.volume_gradient[d][k] - half.hourglass_drag[d] * gamma;
              if constexpr (strength)
                {
                  const std::array<Pack, dim> pull = mean.stress.pull(g, half.hoop[k]);
                  for (int d = 0; d < dim; ++d)
                    force[d][k] -= pull[d];
                }
            }
          if constexpr (kind == ViscosityKind::tensor)
            add_viscous<dim>(
                tensor_force(parameters, x, v, gradient, half, Pack(mass * inverse), mean.sound_speed, first, work),
                select(fill.open, fill.compressed, Pack(1.)), force, work.viscous_force[pack]);
          store_forces(force, first, work);
        }
    }

    template <ViscosityKind kind, int dim>
    void
    corner_forces_with(const FlatMesh<dim> &mesh, const State<dim> &state, const Derived &derived,
                       const HydroParameters &parameters, double dt, StepWork<dim> &work)
    {
      const bool planar = mesh.symmetry == Symmetry::planar;
      if (planar && work.has_strength)
        corner_forces_of<Symmetry::planar, true, kind>(mesh, state, derived, parameters, dt, work);
      else if (planar)
        corner_forces_of<Symmetry::planar, false, kind>(mesh, state, derived, parameters, dt, work);
      else if (work.has_strength)
        corner_forces_of<Symmetry::axisymmetric, true, kind>(mesh, state, derived, parameters, dt, work);
      else
        corner_forces_of<Symmetry::axisymmetric, false, kind>(mesh, state, derived, parameters, dt, work);
    }
  } // namespace
} // namespace whipple::cell_kernels
