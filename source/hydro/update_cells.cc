// SPDX-License-Identifier: LGPL-2.1-or-later

#include <whipple/error.h>
#include <whipple/hydro/cell_kernels.h>
#include <whipple/hydro/closure.h>
#include <whipple/hydro/deviator.h>
#include <whipple/hydro/hourglass.h>
#include <whipple/hydro/trace.h>
#include <whipple/hydro/velocity_gradient.h>

#include <sstream>

namespace whipple::cell_kernels
{
  namespace
  {
    /// Which lanes of a pack need the closure of mixed cells.
    struct Filling
    {
      Pack            materials; ///< number of materials in the cell
      Pack::mask_type mixed;     ///< several materials, a trace, or open void
    };

    template <int dim>
    Filling
    filling(const State<dim> &state, const StepWork<dim> &work, Index first)
    {
      const Pack volume = load(state.volume, first);
      Pack       occupied(0.), materials(0.);
      auto       traces = volume < 0.;
      for (std::size_t m = 0; m < state.material.size(); ++m)
        {
          const MaterialState &material = state.material[m];
          const Pack           v        = load(material.volume, first);
          occupied += v;
          materials += select(v > 0., Pack(1.), Pack(0.));
          traces = traces || (v > 0. && !trace::has_state(material, work.material[m], volume, first));
        }
      const auto open = volume - occupied > closure::closed_share * volume;
      return {materials, (materials > 0. && open) || materials > 1. || traces};
    }

    /// (1 - phi) times the least principal deviator: what is left of the pressure at a free surface, Mbar.
    template <int dim>
    double
    loose_pressure(const State<dim> &state, const MaterialState &material, const StepWork<dim> &work, Index cell)
    {
      if (!work.has_strength)
        return 0.;
      const double solid = material.has_voids() ? 1. - material.void_fraction[cell] : 1.;
      return solid * StoredDeviator<dim>(material, state.index).at(cell).least_principal();
    }

    /// Next volumes of the traces of a cell: beside other material they lie at their normal density; alone they do not
    /// expand, what the cell grows is void, and are not pressed beyond that density. @returns their sum, cm^3
    template <int dim>
    double
    place_traces(const State<dim> &state, Index cell, bool beside_others, StepWork<dim> &work)
    {
      double sum = 0;
      for (std::size_t m = 0; m < state.material.size(); ++m)
        {
          const MaterialState &material = state.material[m];
          MaterialWork<dim>   &next     = work.material[m];
          if (!(material.volume[cell] > 0) || trace::has_state(material, next, state.volume[cell], cell))
            continue;
          const double normal = material.mass[cell] / next.reference_density;
          const double strain = std::min(1., work.volume[cell] / state.volume[cell]);
          next.volume[cell]   = beside_others ? normal : std::max(normal, material.volume[cell] * strain);
          sum += next.volume[cell];
        }
      return sum;
    }

    /// Closure of one mixed cell into work.material[].volume.
    template <int dim>
    void
    share_volume(const State<dim> &state, const Derived &derived, Index cell, StepWork<dim> &work,
                 std::vector<closure::Part> &part, std::vector<double> &result)
    {
      part.clear();
      for (std::size_t m = 0; m < state.material.size(); ++m)
        if (const MaterialState &material = state.material[m];
            trace::has_state(material, work.material[m], state.volume[cell], cell))
          {
            const double c = derived.material[m].sound_speed[cell];
            part.push_back({material.volume[cell], material.density[cell] * c * c, derived.material[m].pressure[cell],
                            loose_pressure(state, material, work, cell)});
          }
      const double traces = place_traces(state, cell, !part.empty(), work);
      if (part.empty())
        return;
      result.resize(part.size());
      closure::share_volume(state.volume[cell] - traces, work.volume[cell] - traces, part, result);
      std::size_t i = 0;
      for (std::size_t m = 0; m < state.material.size(); ++m)
        if (trace::has_state(state.material[m], work.material[m], state.volume[cell], cell))
          work.material[m].volume[cell] = result[i++];
    }

    /// Complain about the first owned cell of a pack whose volume is not positive.
    template <int dim>
    [[noreturn]] void
    throw_inverted(const FlatMesh<dim> &mesh, const State<dim> &state, const Pack &half, const Pack &next, Index first,
                   const StepWork<dim> &work)
    {
      Index cell = first;
      while (cell + 1 < mesh.n_owned && half[cell - first] > 0 && next[cell - first] > 0)
        ++cell;
      std::ostringstream text;
      text.precision(10);
      text << "Lagrange step turns cell " << cell << " (key " << mesh.key[cell] << ") inside out: volume "
           << state.volume[cell] << " -> " << half[cell - first] << " (half step) -> " << next[cell - first]
           << " cm^3; corners";
      for (int k = 0; k < 4; ++k)
        {
          const Index node = mesh.cell_node[cell * 4 + k];
          text << " (" << state.position[0][node] << ", " << state.position[1][node] << ") -> ("
               << work.position[0][node] << ", " << work.position[1][node] << ")";
        }
      throw StateError(text.str());
    }

    /// Relative change of volume in one step beyond which the step was not short enough, whatever the time step
    /// promised: it is taken from velocities that the step itself changes.
    constexpr double largest_change = 0.5;

    /// Complain about the first owned cell of a pack that has changed too much.
    template <int dim>
    [[noreturn]] void
    throw_strained(const FlatMesh<dim> &mesh, const State<dim> &state, const Pack &next, Index first,
                   const StepWork<dim> &work)
    {
      Index cell = first;
      while (cell + 1 < mesh.n_owned && !(work.mass[cell] > 0 && std::abs(next[cell - first] - state.volume[cell]) >
                                                                     largest_change * state.volume[cell]))
        ++cell;
      std::ostringstream text;
      text << "Lagrange step changes the volume of the cell at (" << state.position[0][mesh.cell_node[4 * cell]] << ", "
           << state.position[1][mesh.cell_node[4 * cell]] << ") cm by the factor "
           << next[cell - first] / state.volume[cell] << ": the step is too long";
      throw StateError(text.str());
    }

    template <int dim>
    CornerVectors<dim, Pack>
    load_forces(Index first, const StepWork<dim> &work)
    {
      const Index              last = static_cast<Index>(work.mass.size()) - 1;
      CornerVectors<dim, Pack> force;
      constexpr int            corners = FlatMesh<dim>::corners;
      for (int k = 0; k < corners; ++k)
        for (int d = 0; d < dim; ++d)
          force[d][k] = Pack([&](auto lane) {
            return work.corner_force[(std::min<Index>(first + static_cast<Index>(lane), last) * corners + k) * dim + d];
          });
      return force;
    }

    /// Next volume of every material: the cell's own where it is alone, the closure's in mixed cells.
    template <int dim>
    void
    update_volumes(const State<dim> &state, const Derived &derived, const Filling &fill, const Pack &next_volume,
                   Index first, StepWork<dim> &work, std::vector<closure::Part> &part, std::vector<double> &result)
    {
      store(next_volume, work.volume, first);
      for (std::size_t m = 0; m < state.material.size(); ++m)
        store(select(load(state.material[m].volume, first) > 0., next_volume, Pack(0.)), work.material[m].volume,
              first);
      if (none_of(fill.mixed))
        return;
      const Index end = std::min<Index>(state.n_cells(), first + pack_size);
      for (Index cell = first; cell < end; ++cell)
        if (fill.mixed[cell - first])
          share_volume(state, derived, cell, work, part, result);
    }

    /// Next density and energy of every material. The work on the cell goes to its only material; where there
    /// are several, each gets its own pressure work and of the rest a share by mass.
    template <int dim>
    void
    update_energies(const State<dim> &state, const Filling &fill, const Pack &gain, Index first, StepWork<dim> &work)
    {
      const auto shared = fill.materials > 1.;
      Pack       rest   = gain;
      if (any_of(shared))
        for (std::size_t m = 0; m < state.material.size(); ++m)
          rest += select(shared,
                         Pack(load(work.material[m].half_pressure, first) *
                              (load(work.material[m].volume, first) - load(state.material[m].volume, first))),
                         Pack(0.));
      const Pack cell_mass = load(work.mass, first);
      for (std::size_t m = 0; m < state.material.size(); ++m)
        {
          const MaterialState &old    = state.material[m];
          MaterialWork<dim>   &next   = work.material[m];
          const Pack           volume = load(old.volume, first), mass = load(old.mass, first);
          const Pack           energy = load(old.energy, first);
          const auto           there  = mass > 0.;
          if (none_of(there))
            {
              store(Pack(0.), next.density, first);
              store(Pack(0.), next.energy, first);
              continue;
            }
          const Pack next_volume = load(next.volume, first);
          Pack       specific    = gain / mass;
          if (any_of(shared))
            specific = select(shared,
                              Pack(select(cell_mass > 0., Pack(rest / cell_mass), Pack(0.)) -
                                   load(next.half_pressure, first) * (next_volume - volume) / mass),
                              specific);
          store(select(there && next_volume > 0., Pack(load(old.density, first) * (volume / next_volume)), Pack(0.)),
                next.density, first);
          store(select(there, Pack(energy + specific), Pack(0.)), next.energy, first);
        }
    }

    /// Next stress and plastic strain of every material with strength.
    /// @return plastic work in the cells of the pack
    template <int dim>
    Pack
    update_stresses(const State<dim> &state, const Derived &derived, const VelocityGradient<dim, Pack> &gradient,
                    double dt, Index first, StepWork<dim> &work)
    {
      const DeformationRate<dim, Pack> rate(gradient);
      Pack                             plastic_work(0.);
      for (std::size_t m = 0; m < state.material.size(); ++m)
        {
          const MaterialState   &old  = state.material[m];
          const DerivedMaterial &from = derived.material[m];
          MaterialWork<dim>     &next = work.material[m];
          if (from.shear_modulus.empty())
            continue;
          const auto there = load(old.mass, first) > 0.;
          auto       s     = Deviator<dim, Pack>::zero();
          Pack       strain(0.);
          if (any_of(there))
            {
              const Pack shear = load(from.shear_modulus, first), yield = load(from.yield_stress, first);
              s                    = elastic_trial(StoredDeviator<dim>(old, state.index).load(first), rate, shear, dt);
              const Pack trial     = s.equivalent();
              const Pack increment = plastic_increment(trial, yield, shear);
              s                    = returned(s, trial, yield);
              for (Pack &component : s.component)
                component = select(there, component, Pack(0.));
              strain =
                  select(there, Pack(load(old.fields[state.index.plastic_strain].value, first) + increment), Pack(0.));
              Pack solid = load(next.volume, first);
              if (old.has_voids())
                solid *= 1. - load(old.void_fraction, first);
              plastic_work += select(there, Pack(solid * yield * increment), Pack(0.));
            }
          for (std::size_t i = 0; i < next.stress.size(); ++i)
            store(s.component[i], next.stress[i], first);
          store(strain, next.plastic_strain, first);
        }
      return plastic_work;
    }

    template <Symmetry symmetry, bool strength, int dim>
    Dissipation
    update_cells_of(const FlatMesh<dim> &mesh, const State<dim> &state, const Derived &derived, double dt,
                    StepWork<dim> &work)
    {
      std::vector<closure::Part> &part   = work.mixed_part;
      std::vector<double>        &result = work.mixed_volume;
      Pack                        viscous(0.), hourglassing(0.), plastic(0.);
      for (Index first = 0, pack = 0; first < mesh.n_cells; first += pack_size, ++pack)
        {
          const HalfStepPack<dim>       &half = work.half_step[pack];
          const CornerVectors<dim, Pack> v    = gather_corners(mesh, work.mean_velocity, first);
          const Pack next     = CellGeometry<dim, symmetry>::volume(gather_corners(mesh, work.position, first));
          const auto owned    = lanes_below(first, mesh.n_owned);
          const auto positive = next > 0. && half.volume > 0.;
          if (any_of(owned && !positive))
            throw_inverted(mesh, state, half.volume, next, first, work);
          const Pack start = load(state.volume, first);
          if (any_of(owned && load(work.mass, first) > 0. && abs(next - start) > largest_change * start))
            throw_strained(mesh, state, next, first, work);

          const CornerVectors<dim, Pack> force = load_forces(first, work);
          Pack                           power(0.);
          for (int k = 0; k < FlatMesh<dim>::corners; ++k)
            power += dot_at_corner(k, force, v);

          const Filling fill = filling(state, work, first);
          update_volumes(state, derived, fill, next, first, work, part, result);
          update_energies(state, fill, Pack(-dt * power), first, work);

          const auto gradient = velocity_gradient<dim>(half.volume_gradient, half.hoop, half.volume, v);
          if constexpr (strength)
            plastic += select(owned, update_stresses(state, derived, gradient, dt, first, work), Pack(0.));
          viscous -= select(owned, Pack(dt * half.viscosity * half.volume * gradient.divergence()), Pack(0.));
          const auto rate = hourglass::velocity(half.hourglass_shape, gradient, v);
          hourglassing +=
              select(owned, Pack(dt * (half.hourglass_drag[0] * rate[0] + half.hourglass_drag[1] * rate[1])), Pack(0.));
        }
      return {reduce(viscous), reduce(hourglassing), reduce(plastic)};
    }
  } // namespace

  template <int dim>
  Dissipation
  update_cells(const FlatMesh<dim> &mesh, const State<dim> &state, const Derived &derived, double dt,
               StepWork<dim> &work)
  {
    const bool planar = mesh.symmetry == Symmetry::planar;
    if (planar && work.has_strength)
      return update_cells_of<Symmetry::planar, true>(mesh, state, derived, dt, work);
    if (planar)
      return update_cells_of<Symmetry::planar, false>(mesh, state, derived, dt, work);
    if (work.has_strength)
      return update_cells_of<Symmetry::axisymmetric, true>(mesh, state, derived, dt, work);
    return update_cells_of<Symmetry::axisymmetric, false>(mesh, state, derived, dt, work);
  }

  template Dissipation
  update_cells<2>(const FlatMesh<2> &, const State<2> &, const Derived &, double, StepWork<2> &);
} // namespace whipple::cell_kernels
