// SPDX-License-Identifier: LGPL-2.1-or-later
#include <whipple/remap/interface_normal.h>

#include <cmath>

namespace whipple
{
  namespace
  {
    /// Volume fraction at the nodes.
    template <int dim>
    std::vector<double>
    node_fraction(const FlatMesh<dim> &mesh, const State<dim> &state, const MaterialState &material)
    {
      std::vector<double> fraction(mesh.n_nodes, 0.);
      for (Index node = 0; node < mesh.n_nodes; ++node)
        {
          double volume = 0, filled = 0;
          for (Index i = mesh.node_corner_begin[node]; i < mesh.node_corner_begin[node + 1]; ++i)
            {
              const Index cell = mesh.node_corner[i] / FlatMesh<dim>::corners;
              volume += state.volume[cell];
              filled += material.volume[cell];
            }
          fraction[node] = volume > 0 ? filled / volume : 0.;
        }
      // a hanging node sees only the fine side
      mesh.hang(fraction);
      return fraction;
    }
  } // namespace

  template <int dim>
  InterfaceNormals<dim>
  interface_normals(const FlatMesh<dim> &mesh, const State<dim> &state)
  {
    constexpr int         corners   = FlatMesh<dim>::corners;
    constexpr double      full_cell = 1. - 1e-12;
    InterfaceNormals<dim> normals(state.material.size());
    for (std::size_t m = 0; m < state.material.size(); ++m)
      {
        const MaterialState      &material = state.material[m];
        const std::vector<double> fraction = node_fraction(mesh, state, material);
        for (auto &component : normals[m])
          component.assign(mesh.n_cells, 0.);
        for (Index cell = 0; cell < mesh.n_cells; ++cell)
          {
            if (!(material.volume[cell] > 0) || material.volume[cell] >= full_cell * state.volume[cell])
              continue;
            Vector<dim> n{};
            double      length_2 = 0;
            for (int d = 0; d < dim; ++d)
              {
                for (int k = 0; k < corners; ++k)
                  n[d] += (k >> d & 1 ? -1. : 1.) * fraction[mesh.cell_node[cell * corners + k]];
                length_2 += n[d] * n[d];
              }
            if (length_2 > 0)
              for (int d = 0; d < dim; ++d)
                normals[m][d][cell] = n[d] / std::sqrt(length_2);
          }
      }
    return normals;
  }

  template InterfaceNormals<2>
  interface_normals<2>(const FlatMesh<2> &, const State<2> &);
} // namespace whipple
