// SPDX-License-Identifier: LGPL-2.1-or-later
#include <whipple/state/corner_velocity.h>

namespace whipple
{
  template <int dim>
  double
  cell_mass(const State<dim> &state, Index cell)
  {
    double sum = 0;
    for (const MaterialState &material : state.material)
      sum += material.mass[cell];
    return sum;
  }

  template <int dim>
  std::array<double, 1 << dim>
  corner_shares(const State<dim> &state, Index cell)
  {
    constexpr int               corners = 1 << dim;
    std::array<double, corners> share;
    for (int k = 0; k < corners; ++k)
      share[k] = state.corner_weight[cell * corners + k];
    return share;
  }

  template <int dim>
  CornerVelocities<dim>
  corner_velocities(const FlatMesh<dim> &mesh, const State<dim> &state)
  {
    constexpr int         corners = FlatMesh<dim>::corners;
    CornerVelocities<dim> result(mesh.n_cells);
    for (Index i = 0; i < mesh.n_cells * corners; ++i)
      for (int d = 0; d < dim; ++d)
        result.velocity[d][i] = state.velocity[d][mesh.cell_node[i]];

    for (std::size_t h = 0; h < mesh.hanging.size(); ++h)
      {
        const auto [a, b]   = mesh.master[h].ends();
        double difference_2 = 0;
        for (int d = 0; d < dim; ++d)
          {
            const double difference = state.velocity[d][a] - state.velocity[d][b];
            difference_2 += difference * difference;
          }
        const Index node = mesh.hanging[h];
        for (Index i = mesh.node_corner_begin[node]; i < mesh.node_corner_begin[node + 1]; ++i)
          {
            const Index  corner = mesh.node_corner[i], cell = corner / corners;
            const double mass = corner_shares<dim>(state, cell)[corner % corners] * cell_mass<dim>(state, cell);
            for (int d = 0; d < dim; ++d)
              result.velocity[d][corner] = mesh.master[h].mean(state.velocity[d]);
            result.kinetic_remainder[cell] += mass * difference_2 / 8.;
          }
      }
    return result;
  }

  template double
  cell_mass<2>(const State<2> &, Index);
  template std::array<double, 4>
  corner_shares<2>(const State<2> &, Index);
  template CornerVelocities<2>
  corner_velocities<2>(const FlatMesh<2> &, const State<2> &);
} // namespace whipple
