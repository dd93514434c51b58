// SPDX-License-Identifier: LGPL-2.1-or-later

#include <whipple/error.h>
#include <whipple/hydro/lagrange_step.h>
#include <whipple/mesh/cell_corners.h>
#include <whipple/state/conversion.h>

#include <algorithm>

namespace whipple
{
  namespace
  {
    const char *const viscous = "viscous work", *const hourglass = "hourglass work", *const plastic = "plastic work";
    const ConversionRegistration registrations[] = {{{10, viscous}, ConversionListed::each_step},
                                                    {{20, hourglass}, ConversionListed::each_step},
                                                    {{30, plastic}, ConversionListed::each_step}};

    /// Cell across one subface of one side of a cell, as StepWork::Neighbours has it.
    template <int dim>
    Index
    neighbour(const FlatMesh<dim> &mesh, const Boundaries<dim> &boundaries, Index cell, int side, int part)
    {
      if (mesh.cell_face[side].empty())
        return mesh.n_cells;
      const Index *subface = &mesh.cell_face[side][cell * FlatMesh<dim>::subfaces];
      const Index  face    = subface[part] == none ? subface[0] : subface[part];
      if (face == none)
        return mesh.n_cells;
      const auto &faces  = mesh.faces[side / 2];
      const Index across = faces.cell[side % 2][face];
      if (across != none)
        return across;
      const int  domain_side = faces.side[face];
      const bool mirror      = domain_side >= 0 && (gives_velocity(boundaries[domain_side].kind) ||
                                               boundaries[domain_side].kind == BoundaryKind::reflecting);
      return mirror ? cell : mesh.n_cells;
    }

    template <int dim>
    StepWork<dim>
    make_work(const FlatMesh<dim> &mesh, const std::vector<Material> &materials, const Boundaries<dim> &boundaries)
    {
      StepWork<dim> work;
      for (auto *nodal : {&work.half_position, &work.position, &work.velocity, &work.mean_velocity, &work.node_force})
        for (auto &component : *nodal)
          component.resize(mesh.n_nodes);
      for (auto &component : work.stretch_rate)
        component.assign(mesh.n_cells + 1, 0.);
      work.mass.resize(mesh.n_cells);
      work.corner_force.resize(static_cast<std::size_t>(mesh.n_cells) * FlatMesh<dim>::corners * dim);
      work.volume.resize(mesh.n_cells);
      work.half_step.resize(pack_count(mesh.n_cells));

      work.neighbours.resize(mesh.n_cells);
      for (Index cell = 0; cell < mesh.n_cells; ++cell)
        for (std::size_t i = 0; i < work.neighbours[cell].size(); ++i)
          {
            const Index other        = neighbour(mesh, boundaries, cell, static_cast<int>(i) / FlatMesh<dim>::subfaces,
                                                 static_cast<int>(i) % FlatMesh<dim>::subfaces);
            work.neighbours[cell][i] = other;
            work.has_neighbours      = work.has_neighbours || other != mesh.n_cells;
          }
      if (!work.has_neighbours)
        work.neighbours = {};

      work.material.resize(materials.size());
      work.mixed_part.reserve(materials.size());
      work.mixed_volume.reserve(materials.size());
      for (std::size_t m = 0; m < materials.size(); ++m)
        {
          MaterialWork<dim> &next = work.material[m];
          for (auto *array : {&next.volume, &next.density, &next.energy})
            array->resize(mesh.n_cells);
          next.trace_density     = materials[m].trace_density;
          next.reference_density = materials[m].eos->reference_density();
          if (materials.size() > 1)
            next.half_pressure.resize(mesh.n_cells);
          if (materials[m].void_law)
            {
              next.void_fraction.resize(mesh.n_cells);
              // what gives way at once: a number so large that nothing is left, but 0 times it is 0
              next.yielding = std::min(1e200, materials[m].void_law->yielding(*materials[m].eos));
            }
          if (!materials[m].strength)
            continue;
          work.has_strength = true;
          for (auto &component : next.stress)
            component.resize(mesh.n_cells);
          next.plastic_strain.resize(mesh.n_cells);
        }
      return work;
    }

  } // namespace

  template <int dim>
  void
  initialise_geometry(const FlatMesh<dim> &mesh, State<dim> &state)
  {
    state.volume.resize(mesh.n_cells);
    state.corner_weight.resize(static_cast<std::size_t>(mesh.n_cells) * FlatMesh<dim>::corners);
    for (Index cell = 0; cell < mesh.n_cells; ++cell)
      {
        const CornerVectors<dim> x = cell_corners(mesh, state.position, cell);
        state.volume[cell]         = cell_volume<dim>(mesh.symmetry, x);
        if (cell < mesh.n_owned && !(state.volume[cell] > 0))
          throw StateError("cell " + std::to_string(cell) + " (key " + std::to_string(mesh.key[cell]) +
                           ") has volume " + std::to_string(state.volume[cell]) + " cm^3");
        const CornerValues<dim> corner = corner_volume<dim>(mesh.symmetry, x);
        for (int k = 0; k < FlatMesh<dim>::corners; ++k)
          state.corner_weight[cell * FlatMesh<dim>::corners + k] = corner[k] / state.volume[cell];
      }
  }

  template <int dim>
  LagrangeStep<dim>::LagrangeStep(const FlatMesh<dim> &mesh, const std::vector<Material> &materials,
                                  const Boundaries<dim> &boundaries, const HydroParameters &parameters)
    : mesh_(mesh)
    , materials_(materials)
    , parameters_(parameters)
    , motion_(mesh, boundaries, materials)
    , work_(make_work(mesh, materials, boundaries))
    , scratch_(material_passes::make_scratch(materials, mesh.n_cells))
    , needs_strain_rate_(std::any_of(materials.begin(), materials.end(), [](const Material &material) {
      return material.strength && material.strength->needs_strain_rate();
    }))
  {
    if (parameters.viscosity != ViscosityKind::scalar)
      work_.viscous_force.resize(pack_count(mesh.n_cells));
  }

  template <int dim>
  void
  LagrangeStep<dim>::update_node_mass(State<dim> &state) const
  {
    state.node_mass.assign(mesh_.n_nodes, 0.);
    for (Index node = 0; node < mesh_.n_nodes; ++node)
      for (Index i = mesh_.node_corner_begin[node]; i < mesh_.node_corner_begin[node + 1]; ++i)
        {
          const Index corner = mesh_.node_corner[i];
          double      mass   = 0;
          for (const MaterialState &material : state.material)
            mass += material.mass[corner / FlatMesh<dim>::corners];
          state.node_mass[node] += state.corner_weight[corner] * mass;
        }
    mesh_.share_out(state.node_mass);
    for (const Index node : mesh_.hanging)
      state.node_mass[node] = 0;
  }

  template <int dim>
  void
  LagrangeStep<dim>::evaluate_pressure(const State<dim> &state, Derived &derived)
  {
    material_passes::evaluate_pressure(materials_, state, scratch_, derived);
  }

  template <int dim>
  void
  LagrangeStep<dim>::evaluate_strength(const State<dim> &state, Derived &derived)
  {
    if (!work_.has_strength)
      return;
    if (needs_strain_rate_)
      {
        derived.strain_rate.resize(mesh_.n_cells);
        cell_kernels::strain_rates(mesh_, state, derived.strain_rate);
      }
    material_passes::evaluate_strength(materials_, state, scratch_, derived);
  }

  template <int dim>
  void
  LagrangeStep<dim>::evaluate(const State<dim> &state, Derived &derived)
  {
    evaluate_pressure(state, derived);
    evaluate_strength(state, derived);
  }

  template <int dim>
  TimeStepLimit
  LagrangeStep<dim>::time_step(const State<dim> &state, const Derived &derived, std::span<const Index> exempt)
  {
    if (!motion_.drives_nodes())
      return find_time_step<dim>(mesh_, state, derived, state.velocity, parameters_, work_, exempt);
    // a side that is about to move its nodes squeezes the cells beside it, whatever velocity they still have
    for (int d = 0; d < dim; ++d)
      std::copy(state.velocity[d].begin(), state.velocity[d].end(), work_.velocity[d].begin());
    motion_.drive(state, work_.velocity);
    return find_time_step<dim>(mesh_, state, derived, work_.velocity, parameters_, work_, exempt);
  }

  template <int dim>
  std::vector<Index>
  LagrangeStep<dim>::slivers(const State<dim> &state, const Derived &derived, double bound) const
  {
    return find_slivers<dim>(mesh_, state, derived, parameters_, work_, bound);
  }

  template <int dim>
  void
  LagrangeStep<dim>::commit(State<dim> &state, double dt)
  {
    state.time += dt;
    state.volume.swap(work_.volume);
    for (int d = 0; d < dim; ++d)
      {
        state.position[d].swap(work_.position[d]);
        state.velocity[d].swap(work_.velocity[d]);
      }
    for (std::size_t m = 0; m < materials_.size(); ++m)
      {
        MaterialState     &material = state.material[m];
        MaterialWork<dim> &next     = work_.material[m];
        material.volume.swap(next.volume);
        material.density.swap(next.density);
        material.energy.swap(next.energy);
        if (materials_[m].void_law)
          material.void_fraction.swap(next.void_fraction);
        if (!materials_[m].strength)
          continue;
        for (std::size_t i = 0; i < next.stress.size(); ++i)
          material.fields[state.index.stress[i]].value.swap(next.stress[i]);
        material.fields[state.index.plastic_strain].value.swap(next.plastic_strain);
      }
  }

  template <int dim>
  Bookings<dim>
  LagrangeSums<dim>::bookings() const
  {
    Bookings<dim> result;
    result.convert(viscous, viscous_work);
    result.convert(hourglass, hourglass_work);
    result.convert(plastic, plastic_work);
    ConservedTotals<dim> given; // to the sides: minus what they gave
    given.kinetic_energy -= boundary_work;
    for (int d = 0; d < dim; ++d)
      given.momentum[d] -= boundary_momentum[d];
    result.leave("sides of the domain", given);
    return result;
  }

  template <int dim>
  LagrangeSums<dim>
  LagrangeStep<dim>::advance(State<dim> &state, const Derived &derived, double dt,
                             std::span<const RigidFragment<dim>> rigid)
  {
    motion_.predict(state, dt, work_);
    cell_kernels::stretch_rates(mesh_, state, work_);
    cell_kernels::corner_forces(mesh_, state, derived, parameters_, dt, work_);
    motion_.load_sides(state, derived, dt, work_);
    const BoundaryExchange<dim> exchange    = motion_.move(state, dt, rigid, work_);
    cell_kernels::Dissipation   dissipation = cell_kernels::update_cells(mesh_, state, derived, dt, work_);
    if (!work_.viscous_force.empty())
      dissipation.viscous = cell_kernels::viscous_work(mesh_, dt, work_);
    material_passes::advance_voids(materials_, state, dt, scratch_, work_);
    material_passes::check_densities(mesh_, materials_, state, work_);

    commit(state, dt);
    return {dissipation.viscous, dissipation.hourglass, dissipation.plastic, exchange.work, exchange.momentum};
  }

  template void
  initialise_geometry<2>(const FlatMesh<2> &, State<2> &);
  template struct LagrangeSums<2>;
  template class LagrangeStep<2>;
} // namespace whipple
