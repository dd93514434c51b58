// SPDX-License-Identifier: LGPL-2.1-or-later
#include <whipple/refinement/smoothness.h>

#include <algorithm>
#include <array>
#include <cmath>

namespace whipple
{
  namespace
  {
    /// Cell means of what is compared: density, pressure, momentum density.
    template <int dim>
    struct CellMeans
    {
      static constexpr int size = 2 + dim;

      CellMeans(const FlatMesh<dim> &mesh, const State<dim> &state, const Derived &derived)
        : value(mesh.n_cells)
        , full(mesh.n_cells)
      {
        constexpr double round_off = 1e-9;
        for (Index c = 0; c < mesh.n_cells; ++c)
          {
            double volume = 0;
            auto  &v      = value[c];
            v             = {};
            for (std::size_t i = 0; i < state.material.size(); ++i)
              {
                const MaterialState &m = state.material[i];
                volume += m.volume[c];
                v[0] += m.mass[c] / state.volume[c];
                v[1] += m.volume[c] / state.volume[c] * derived.material[i].pressure[c];
              }
            full[c] = volume > (1. - round_off) * state.volume[c];
            for (int d = 0; d < dim; ++d)
              for (int k = 0; k < FlatMesh<dim>::corners; ++k)
                v[2 + d] +=
                    v[0] * state.velocity[d][mesh.cell_node[c * FlatMesh<dim>::corners + k]] / FlatMesh<dim>::corners;
          }
      }

      std::vector<std::array<double, size>> value;
      std::vector<std::uint8_t>             full; ///< no open void
    };
  } // namespace

  template <int dim>
  std::vector<double>
  change_over_cells(const FlatMesh<dim> &mesh, const State<dim> &state, const Derived &derived,
                    const Boundaries<dim> &boundaries, MPI_Comm communicator)
  {
    const CellMeans<dim>  means(mesh, state, derived);
    std::array<double, 3> largest{}; // density, pressure, component of the momentum density
    for (Index c = 0; c < mesh.n_owned; ++c)
      for (int q = 0; q < CellMeans<dim>::size; ++q)
        largest[std::min(q, 2)] = std::max(largest[std::min(q, 2)], std::abs(means.value[c][q]));
    MPI_Allreduce(MPI_IN_PLACE, largest.data(), 3, MPI_DOUBLE, MPI_MAX, communicator);

    std::vector<double> change(mesh.n_owned, 0.);
    for (const FlatFaces<dim> &faces : mesh.faces)
      for (Index f = 0; f < faces.size(); ++f)
        for (int s = 0; s < 2; ++s)
          {
            const Index c = faces.cell[s][f], other = faces.cell[1 - s][f];
            if (c == none || c >= mesh.n_owned)
              continue;
            if (other == none)
              {
                const int side = faces.side[f];
                if (side < 0)
                  change[c] = 1.;
                else if (boundaries[side].kind == BoundaryKind::reflecting && largest[2] > 0)
                  change[c] = std::max(
                      change[c], 2. * std::abs(means.value[c][2 + normal_axis<dim>(boundaries, side)]) / largest[2]);
                continue;
              }
            if (!means.full[c] || !means.full[other])
              {
                change[c] = 1.;
                continue;
              }
            const double to_cell_size = 2. * mesh.size[c] / (mesh.size[c] + mesh.size[other]);
            for (int q = 0; q < CellMeans<dim>::size; ++q)
              if (const double scale = largest[std::min(q, 2)]; scale > 0)
                change[c] =
                    std::max(change[c], to_cell_size / scale * std::abs(means.value[other][q] - means.value[c][q]));
          }
    return change;
  }

  template std::vector<double>
  change_over_cells(const FlatMesh<2> &, const State<2> &, const Derived &, const Boundaries<2> &, MPI_Comm);
} // namespace whipple
