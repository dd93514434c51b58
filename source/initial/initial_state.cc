// SPDX-License-Identifier: LGPL-2.1-or-later
#include <whipple/error.h>
#include <whipple/initial/exact_means.h>
#include <whipple/initial/initial_state.h>
#include <whipple/mesh/cell_corners.h>

#include <cmath>
#include <sstream>

namespace whipple
{
  namespace
  {
    template <int dim>
    bool
    is_given(const Vector<dim> &v)
    {
      for (const double component : v)
        if (std::isnan(component))
          return false;
      return true;
    }

    /// Points of a cell where the solution has material.
    template <int dim>
    std::vector<VolumePoint<dim>>
    material_points(const exact::ExactSolution<dim> &solution, Symmetry symmetry, const CornerVectors<dim> &cell,
                    double time)
    {
      std::vector<VolumePoint<dim>> points = volume_points<dim>(solution, symmetry, cell, time);
      std::erase_if(points, [&](const VolumePoint<dim> &p) { return !(solution.at(p.x, time).density > 0); });
      return points;
    }
  } // namespace

  template <int dim>
  ExactFilling<dim>::ExactFilling(const exact::ExactSolution<dim> &solution, const FieldLayout &layout,
                                  const FlatMesh<dim> &mesh, const State<dim> &state)
    : solution_(solution)
    , layout_(layout)
    , mesh_(mesh)
    , node_velocity_(mesh.n_nodes)
  {
    for (Index n = 0; n < mesh.n_nodes; ++n)
      {
        Vector<dim> x;
        for (int d = 0; d < dim; ++d)
          x[d] = state.position[d][n];
        node_velocity_[n] = solution.at(x, state.time).velocity;
      }
    for (std::size_t h = 0; h < mesh.hanging.size(); ++h)
      for (int d = 0; d < dim; ++d)
        node_velocity_[mesh.hanging[h]][d] = mesh.master[h].mean([&](Index n) { return node_velocity_[n][d]; });
  }

  template <int dim>
  CellFilling<dim>
  ExactFilling<dim>::fill(const Body<dim> &body, const State<dim> &state, Index cell) const
  {
    const CornerVectors<dim> corner = cell_corners(mesh_, state.position, cell);
    const auto               points = material_points(solution_, mesh_.symmetry, corner, state.time);
    const ExactMeans<dim>    means  = exact_means<dim>(solution_, points, state.time);
    CellFilling<dim>         filling{means.density, means.energy, {}};
    if (points.empty() && body.density > 0)
      filling = {body.density, body.energy, {}}; // a sliver between all points: its state does not matter
    if (std::isnan(filling.energy) && !std::isnan(means.pressure))
      filling.energy = layout_.materials[body.material].eos->energy_of_pressure(filling.density, means.pressure);
    if (!(filling.density > 0) || std::isnan(filling.energy) || (!points.empty() && !is_given<dim>(means.velocity)))
      {
        std::ostringstream text;
        text << "body '" << body.name << "': the exact solution '" << solution_.name() << "' gives density "
             << filling.density << " g/cm^3, energy " << filling.energy << " Mbar cm^3/g, velocity ("
             << means.velocity[0] << ", " << means.velocity[1] << ") cm/us in the cell at (" << corner[0][0] << ", "
             << corner[1][0] << ") cm; an initial state needs them all";
        throw StateError(text.str());
      }
    for (int k = 0; k < FlatMesh<dim>::corners; ++k)
      {
        // a corner on the edge of the material may lie outside it by round-off
        const Vector<dim> &v = node_velocity_[mesh_.cell_node[cell * FlatMesh<dim>::corners + k]];
        filling.velocity[k]  = is_given<dim>(v) ? v : (points.empty() ? body.velocity : means.velocity);
      }
    return filling;
  }

  template <int dim>
  void
  ExactFilling<dim>::add_hanging_energy(const State<dim> &state, const std::vector<std::uint8_t> &marked,
                                        CornerVelocities<dim> &corners) const
  {
    for (std::size_t h = 0; h < mesh_.hanging.size(); ++h)
      {
        const auto [a, b] = mesh_.master[h].ends();
        const Index node  = mesh_.hanging[h];
        if (!is_given<dim>(node_velocity_[node]))
          continue;
        double difference_2 = 0;
        for (int d = 0; d < dim; ++d)
          {
            const double difference = node_velocity_[a][d] - node_velocity_[b][d];
            difference_2 += difference * difference;
          }
        for (Index i = mesh_.node_corner_begin[node]; i < mesh_.node_corner_begin[node + 1]; ++i)
          {
            const Index corner = mesh_.node_corner[i], cell = corner / FlatMesh<dim>::corners;
            if (marked[cell])
              corners.kinetic_remainder[cell] +=
                  state.corner_weight[corner] * cell_mass<dim>(state, cell) * difference_2 / 8.;
          }
      }
  }

  template class ExactFilling<2>;
} // namespace whipple
