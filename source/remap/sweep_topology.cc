// SPDX-License-Identifier: LGPL-2.1-or-later
#include <whipple/remap/sweep_topology.h>

namespace whipple
{
  template <int dim>
  SweepTopology<dim>::SweepTopology(const FlatMesh<dim> &mesh, const int given_axis)
    : axis(given_axis)
    , n_faces(mesh.faces[given_axis].size())
    , faces(&mesh.faces[given_axis])
    , weight_below(mesh.n_cells)
    , weight_above(mesh.n_cells)
  {
    constexpr int subfaces = FlatMesh<dim>::subfaces;
    static_assert(subfaces == 2, "the face and neighbour lists of a sweep hold two subfaces a side");

    const auto connect = [&](const int upper_side, std::array<std::vector<Index>, 2> &face,
                             std::array<std::vector<Index>, 2> &neighbour) {
      const std::vector<Index> &side = mesh.cell_face[2 * axis + upper_side];
      for (int s = 0; s < subfaces; ++s)
        {
          face[s].resize(mesh.n_cells);
          neighbour[s].resize(mesh.n_cells);
          for (Index c = 0; c < mesh.n_cells; ++c)
            {
              const Index f   = side[c * subfaces + s];
              face[s][c]      = f == none ? n_faces : f;
              const Index n   = f == none ? none : faces->cell[upper_side][f];
              neighbour[s][c] = n != none ? n : s == 0 ? c : neighbour[0][c];
            }
        }
    };
    connect(0, lower, below);
    connect(1, upper, above);

    for (Index c = 0; c < mesh.n_cells; ++c)
      {
        const double h      = mesh.size[c];
        const double d_low  = 0.5 * (h + mesh.size[below[0][c]]);
        const double d_high = 0.5 * (h + mesh.size[above[0][c]]);
        weight_below[c]     = h * d_high / (d_low * (d_low + d_high));
        weight_above[c]     = h * d_low / (d_high * (d_low + d_high));
      }

    for (int s = 0; s < 2; ++s)
      {
        part_share[s].assign(n_faces, 1.);
        for (Index f = 0; f < n_faces; ++f)
          {
            const Index c = faces->cell[s][f];
            if (c == none || faces->part[s][f] < 0)
              continue;
            part_share[s][f] = 0.5;
            if (mesh.symmetry == Symmetry::axisymmetric && axis == 1)
              {
                const double r = mesh.lower[0][c], h = mesh.size[c];
                const double inner = 0.5 * (2. * r + 0.5 * h) / (2. * r + h);
                part_share[s][f]   = faces->part[s][f] ? 1. - inner : inner;
              }
          }
      }

    for (Index f = 0; f < n_faces; ++f)
      if (faces->side[f] >= 0)
        boundary_faces.push_back(f);
      else if (faces->cell[0][f] == none || faces->cell[1][f] == none)
        end_faces.push_back(f);
  }

  template struct SweepTopology<2>;
} // namespace whipple
