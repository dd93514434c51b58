// SPDX-License-Identifier: LGPL-2.1-or-later
#include <whipple/remap/node_topology.h>

#include <algorithm>
#include <cmath>

namespace whipple
{
  namespace
  {
    /// Whether cells of several levels meet at a node.
    template <int dim>
    bool
    meets_levels(const FlatMesh<dim> &mesh, const Index node)
    {
      const auto level = [&](Index i) { return mesh.level[mesh.node_corner[i] / FlatMesh<dim>::corners]; };
      for (Index i = mesh.node_corner_begin[node]; i < mesh.node_corner_begin[node + 1]; ++i)
        if (level(i) != level(mesh.node_corner_begin[node]))
          return true;
      return false;
    }
  } // namespace

  template <int dim>
  NodeTopology<dim>::NodeTopology(const FlatMesh<dim> &mesh)
    : kind(mesh.n_nodes, NodeKind::interior)
    , hanging_place(mesh.n_nodes, none)
    , uneven(mesh.n_nodes, 0)
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
      if (hanging_place[n] == none)
        uneven[n] = !hanging_of(n).empty() || meets_levels(mesh, n);
    for (Index n = 0; n < mesh.n_nodes; ++n)
      {
        const Index begin = mesh.node_corner_begin[n], end = mesh.node_corner_begin[n + 1];
        bool        even = true;
        for (Index i = begin; i < end; ++i)
          for (int k = 0; k < corners; ++k)
            {
              const Index near = mesh.cell_node[mesh.node_corner[i] / corners * corners + k];
              even             = even && hanging_place[near] == none && !uneven[near];
            }
        const bool interior = even && end - begin == corners && mesh.node_side[n] == 0;
        kind[n] = hanging_place[n] != none ? NodeKind::hanging : interior ? NodeKind::interior : NodeKind::special;
        for (int axis = 0; axis < dim; ++axis)
          {
            previous[axis][n] = next[axis][n] = n;
            for (Index i = begin; i < end && hanging_place[n] == none; ++i)
              {
                const Index corner = mesh.node_corner[i], other = mesh.cell_node[corner ^ (1 << axis)];
                Index      &nearest  = (corner >> axis & 1 ? previous : next)[axis][n];
                const auto  distance = [&](Index to) {
                  return std::abs(mesh.node_point[axis][to] - mesh.node_point[axis][n]);
                };
                if (nearest == n || distance(other) < distance(nearest))
                  nearest = other;
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
