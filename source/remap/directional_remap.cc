// SPDX-License-Identifier: LGPL-2.1-or-later
#include <whipple/error.h>
#include <whipple/mesh/cell_corners.h>
#include <whipple/remap/directional_remap.h>
#include <whipple/remap/swept_volume.h>

#include <cmath>
#include <limits>
#include <string>

namespace whipple
{
  namespace
  {
    /// What materials may exceed a cell by before they are cut back: far above round-off, far below physics.
    constexpr double overfull_tolerance = 1e-12;
    /// ... and by what before it is worth a word: more than round-off of the sweeps, a pressure of some bars.
    constexpr double overfull_noticed = 1e-6;
    /// A cell filled this closely is taken as full.
    constexpr double full_tolerance = 1e-10;
    /// ... and this closely by round-off alone, which may not disturb the density.
    constexpr double round_off = 64. * std::numeric_limits<double>::epsilon();
    /// What swept volumes may miss the undeformed volume by.
    constexpr double closure_tolerance = 1e-9;

    template <int dim>
    std::vector<double>
    undeformed_volumes(const FlatMesh<dim> &mesh)
    {
      std::vector<double> volume(mesh.n_cells);
      for (Index c = 0; c < mesh.n_cells; ++c)
        {
          volume[c] = cell_volume<dim>(mesh.symmetry, cell_corners(mesh, mesh.node_point, c));
        }
      return volume;
    }

    template <int dim>
    void
    sum_masses(const State<dim> &state, std::vector<double> &sum)
    {
      sum = state.material[0].mass;
      for (std::size_t m = 1; m < state.material.size(); ++m)
        for (std::size_t c = 0; c < sum.size(); ++c)
          sum[c] += state.material[m].mass[c];
    }

    /// Cut materials that hold more than their cell back to its volume, at constant mass.
    template <int dim>
    void
    compress_overfull(State<dim> &state, const Index n_owned, RemapSums<dim> &report)
    {
      for (Index c = 0; c < state.n_cells(); ++c)
        {
          double sum = 0;
          for (const MaterialState &material : state.material)
            sum += material.volume[c];
          if (!(sum > state.volume[c] * (1. + overfull_tolerance)))
            continue;
          const double ratio = state.volume[c] / sum;
          for (MaterialState &material : state.material)
            if (material.volume[c] > 0)
              {
                material.volume[c] *= ratio;
                material.density[c] = material.mass[c] / material.volume[c];
              }
          if (c < n_owned)
            {
              report.compressed.add(sum - state.volume[c]);
              report.cells_compressed += sum > state.volume[c] * (1. + overfull_noticed);
            }
        }
    }
  } // namespace

  template <int dim>
  DirectionalRemap<dim>::DirectionalRemap(const FlatMesh<dim> &mesh, const Boundaries<dim> &boundaries,
                                          const RemapParameters &parameters)
    : mesh_(&mesh)
    , parameters_(parameters)
    , fixed_volume_(undeformed_volumes(mesh))
    , mass_before_(mesh.n_cells)
    , mass_after_(mesh.n_cells)
    , topology_{SweepTopology<dim>(mesh, 0), SweepTopology<dim>(mesh, 1)}
    , volume_flux_(mesh, parameters)
    , material_transport_(mesh, boundaries, parameters)
    , momentum_transport_(mesh, boundaries, parameters)
  {
    for (int axis = 0; axis < dim; ++axis)
      {
        swept_[axis].assign(mesh.faces[axis].size() + 1, 0.);
        mass_flux_.reserve(swept_[axis].size());
      }
  }

  template <int dim>
  AdvectionLimit
  DirectionalRemap<dim>::time_step(const State<dim> &state) const
  {
    double rate    = 0; // edges a microsecond
    Index  fastest = none;
    for (Index c = 0; c < mesh_->n_owned; ++c)
      {
        double speed = 0;
        for (int k = 0; k < FlatMesh<dim>::corners; ++k)
          for (int d = 0; d < dim; ++d)
            speed = std::max(speed, std::abs(state.velocity[d][mesh_->cell_node[FlatMesh<dim>::corners * c + k]]));
        if (speed / mesh_->size[c] > rate)
          {
            rate    = speed / mesh_->size[c];
            fastest = c;
          }
      }
    return {rate > 0 ? parameters_.advection_limit / rate : std::numeric_limits<double>::infinity(), fastest};
  }

  template <int dim>
  void
  DirectionalRemap<dim>::begin(const State<dim> &state)
  {
    for (int axis = 0; axis < dim; ++axis)
      compute_swept_volumes(*mesh_, state, axis, swept_[axis]);
  }

  template <int dim>
  RemapSums<dim>
  DirectionalRemap<dim>::sweep(State<dim> &state, const int axis, const MeetingHalo<dim> &halo)
  {
    RemapSums<dim>            report;
    const SweepTopology<dim> &topology = topology_[axis];
    volume_flux_.compute(state, topology, swept_[axis], report);
    sum_masses(state, mass_before_);
    mass_flux_.assign(topology.n_faces + 1, 0.);
    for (std::size_t m = 0; m < state.material.size(); ++m)
      material_transport_.move(state.material[m], static_cast<Index>(m), volume_flux_, topology,
                               state.index.odd_at(axis), mass_flux_, report);
    for (Index c = 0; c < mesh_->n_cells; ++c)
      state.volume[c] -= topology.net(swept_[axis], c);
    compress_overfull(state, mesh_->n_owned, report);
    sum_masses(state, mass_after_);
    momentum_transport_.move(state, topology, mass_flux_, mass_before_, mass_after_, halo, report);
    return report;
  }

  template <int dim>
  void
  DirectionalRemap<dim>::finish(State<dim> &state)
  {
    for (int d = 0; d < dim; ++d)
      state.position[d] = mesh_->node_point[d];
    for (Index c = 0; c < mesh_->n_cells; ++c)
      {
        const double volume = fixed_volume_[c];
        if (c < mesh_->n_owned && !(std::abs(state.volume[c] - volume) <= closure_tolerance * volume))
          throw StateError("remap: swept volumes of cell " + std::to_string(c) + " add up to " +
                           std::to_string(state.volume[c] / volume) + " of its undeformed volume");
        state.volume[c] = volume;
        for (MaterialState &material : state.material)
          {
            const double excess = std::abs(material.volume[c] - volume) / volume;
            if (!(excess <= full_tolerance))
              continue;
            material.volume[c] = volume;
            if (excess <= round_off)
              material.mass[c] = material.density[c] * volume;
            else
              material.density[c] = material.mass[c] / volume;
          }
      }
  }

  template class DirectionalRemap<2>;
} // namespace whipple
