// SPDX-License-Identifier: LGPL-2.1-or-later
#include <whipple/remap/node_topology.h>

#include <algorithm>

namespace whipple
{
  template <int dim>
  NodeTopology<dim>::NodeTopology(const FlatMesh<dim> &mesh)
    : kind(mesh.n_nodes, NodeKind::interior)
    , hanging_place(mesh.n_nodes, none)
    , hanging_begin_(mesh.n_nodes + 1, 0)
    , on_side_(mesh.n_nodes, 0)
  {
    constexpr int corners = FlatMesh<dim>::corners;
    for (std::size_t i = 0; i < mesh.hanging.size(); ++i)
      {
        hanging_place[mesh.hanging[i]] = static_cast<Index>(i);
        for (const Index m : mesh.master[i])
          ++hanging_begin_[m + 1];
      }
    for (Index n = 0; n < mesh.n_nodes; ++n)
      hanging_begin_[n + 1] += hanging_begin_[n];
    hanging_.resize(hanging_begin_[mesh.n_nodes]);
    std::vector<Index> filled(hanging_begin_.begin(), hanging_begin_.end() - 1);
    for (std::size_t i = 0; i < mesh.hanging.size(); ++i)
      for (const Index m : mesh.master[i])
        hanging_[filled[m]++] = mesh.hanging[i];

    for (int axis = 0; axis < dim; ++axis)
      {
        previous[axis].resize(mesh.n_nodes);
        next[axis].resize(mesh.n_nodes);
      }
    for (Index n = 0; n < mesh.n_nodes; ++n)
      {
        const Index begin = mesh.node_corner_begin[n], end = mesh.node_corner_begin[n + 1];
        bool        regular = hanging_place[n] == none && hanging_of(n).empty();
        for (Index i = begin; i < end; ++i)
          {
            const Index c = mesh.node_corner[i] / corners;
            regular       = regular && mesh.level[c] == mesh.level[mesh.node_corner[begin] / corners];
            for (int k = 0; k < corners; ++k)
              regular = regular && hanging_place[mesh.cell_node[c * corners + k]] == none;
          }
        const bool interior = regular && end - begin == corners && mesh.node_side[n] == 0;
        kind[n] = hanging_place[n] != none ? NodeKind::hanging : interior ? NodeKind::interior : NodeKind::special;
        for (int axis = 0; axis < dim; ++axis)
          {
            previous[axis][n] = next[axis][n] = n;
            for (Index i = begin; i < end && regular; ++i)
              {
                const Index corner                              = mesh.node_corner[i];
                (corner >> axis & 1 ? previous : next)[axis][n] = mesh.cell_node[corner ^ (1 << axis)];
              }
          }
      }

    for (int axis = 0; axis < dim; ++axis)
      {
        const FlatFaces<dim> &faces = mesh.faces[axis];
        for (Index f = 0; f < faces.size(); ++f)
          for (int s = 0; s < 2; ++s)
            {
              if (faces.cell[s][f] != none && faces.part[s][f] == 0)
                coarse_cells[axis].push_back(faces.cell[s][f]);
              const Index n = faces.node[2 * f + s];
              if (faces.side[f] >= 0 && !(on_side_[n] >> axis & 1))
                {
                  on_side_[n] |= 1 << axis;
                  side_nodes[axis].push_back(n);
                }
            }
        // a cell with fine neighbours on both sides is listed once
        std::sort(coarse_cells[axis].begin(), coarse_cells[axis].end());
        coarse_cells[axis].erase(std::unique(coarse_cells[axis].begin(), coarse_cells[axis].end()),
                                 coarse_cells[axis].end());
      }
  }

  template struct NodeTopology<2>;
} // namespace whipple
