// SPDX-License-Identifier: LGPL-2.1-or-later
#pragma once

#include <whipple/mesh/cell_geometry.h>
#include <whipple/mesh/flat_builder.h>
#include <whipple/remap/directional_remap.h>

#include <algorithm>
#include <cmath>
#include <functional>
#include <vector>

/// Meshes and states for the tests of the remap.
namespace remap_case
{
  using whipple::Index;
  using whipple::State;
  using whipple::Symmetry;
  using Mesh    = whipple::FlatMesh<2>;
  using Lattice = whipple::Lattice<2>;
  using Point   = whipple::Vector<2>;

  /// Leaves whose size is at most max(finest, 0.45 distance(centre)): 2:1 balanced for any distance function.
  inline Mesh
  graded_mesh(const Lattice &lattice, const std::function<double(const Point &)> &distance)
  {
    std::vector<whipple::CellKey>                                    keys;
    const std::function<void(int, const whipple::LatticePoint<2> &)> visit =
        [&](const int level, const whipple::LatticePoint<2> &point) {
          const int    extent = lattice.extent(level);
          const double size   = extent * lattice.spacing;
          const Point  centre{lattice.origin[0] + (point[0] + 0.5 * extent) * lattice.spacing,
                             lattice.origin[1] + (point[1] + 0.5 * extent) * lattice.spacing};
          if (level == lattice.max_level || size <= 0.45 * distance(centre))
            return keys.push_back(whipple::make_key<2>(level, point));
          for (int k = 0; k < 4; ++k)
            visit(level + 1, {point[0] + (k & 1) * extent / 2, point[1] + (k >> 1) * extent / 2});
        };
    for (int j = 0; j < lattice.roots[1]; ++j)
      for (int i = 0; i < lattice.roots[0]; ++i)
        visit(0, {i * lattice.extent(0), j * lattice.extent(0)});
    const Index n = static_cast<Index>(keys.size());
    return whipple::build_flat_mesh<2>(lattice, keys, n, std::vector<std::uint8_t>(n, 0), 0, whipple::Cohesion::bonded);
  }

  inline Mesh
  uniform_mesh(const Symmetry symmetry, const double size, const std::array<int, 2> cells)
  {
    return graded_mesh({symmetry, {0., 0.}, size, cells, 0}, [](const Point &) { return 0.; });
  }

  inline double
  cell_volume(const Mesh &mesh, const State<2> &state, const Index c)
  {
    whipple::CornerVectors<2> x;
    for (int d = 0; d < 2; ++d)
      for (int k = 0; k < 4; ++k)
        x[d][k] = state.position[d][mesh.cell_node[4 * c + k]];
    return whipple::cell_volume(mesh.symmetry, x);
  }

  /// Empty state at rest on the undeformed mesh; every material has phi and one field of each carrier.
  inline State<2>
  empty_state(const Mesh &mesh, const int n_materials)
  {
    State<2> state;
    state.node_mass.assign(mesh.n_nodes, 0.);
    for (int d = 0; d < 2; ++d)
      {
        state.position[d] = mesh.node_point[d];
        state.velocity[d].assign(mesh.n_nodes, 0.);
      }
    state.volume.resize(mesh.n_cells);
    state.corner_weight.resize(4 * mesh.n_cells);
    for (Index c = 0; c < mesh.n_cells; ++c)
      {
        state.volume[c] = cell_volume(mesh, state, c);
        whipple::CornerVectors<2> x;
        for (int d = 0; d < 2; ++d)
          for (int k = 0; k < 4; ++k)
            x[d][k] = state.position[d][mesh.cell_node[4 * c + k]];
        const auto w = whipple::corner_volume(mesh.symmetry, x);
        for (int k = 0; k < 4; ++k)
          state.corner_weight[4 * c + k] = w[k] / (w[0] + w[1] + w[2] + w[3]);
      }
    state.material.resize(n_materials);
    for (whipple::MaterialState &material : state.material)
      {
        for (std::vector<double> *value :
             {&material.volume, &material.mass, &material.density, &material.energy, &material.void_fraction})
          value->assign(mesh.n_cells, 0.);
        material.fields = {{{"plastic strain", "1", whipple::Carrier::mass}, material.volume},
                           {{"deviatoric stress rr", "Mbar", whipple::Carrier::volume}, material.volume}};
      }
    return state;
  }

  /// Node masses from the corners, hanging nodes' given to their masters, whose mean velocity they take.
  inline void
  lump(const Mesh &mesh, State<2> &state)
  {
    std::fill(state.node_mass.begin(), state.node_mass.end(), 0.);
    for (Index c = 0; c < mesh.n_cells; ++c)
      for (const whipple::MaterialState &material : state.material)
        for (int k = 0; k < 4; ++k)
          state.node_mass[mesh.cell_node[4 * c + k]] += state.corner_weight[4 * c + k] * material.mass[c];
    for (std::size_t i = 0; i < mesh.hanging.size(); ++i)
      {
        const Index h = mesh.hanging[i], a = mesh.master[i][0], b = mesh.master[i][1];
        state.node_mass[a] += 0.5 * state.node_mass[h];
        state.node_mass[b] += 0.5 * state.node_mass[h];
        state.node_mass[h] = 0;
        for (int d = 0; d < 2; ++d)
          state.velocity[d][h] = 0.5 * (state.velocity[d][a] + state.velocity[d][b]);
      }
  }

  /// Nodes move with their velocity; cells and materials keep their fractions (volume and density follow: `fill`
  /// the cells afterwards where that matters).
  inline void
  move_nodes(const Mesh &mesh, State<2> &state, const double dt)
  {
    for (int d = 0; d < 2; ++d)
      for (Index n = 0; n < mesh.n_nodes; ++n)
        state.position[d][n] = mesh.node_point[d][n] + dt * state.velocity[d][n];
    for (std::size_t i = 0; i < mesh.hanging.size(); ++i)
      for (int d = 0; d < 2; ++d)
        state.position[d][mesh.hanging[i]] =
            0.5 * (state.position[d][mesh.master[i][0]] + state.position[d][mesh.master[i][1]]);
    for (Index c = 0; c < mesh.n_cells; ++c)
      state.volume[c] = cell_volume(mesh, state, c);
  }

  struct Totals
  {
    double mass = 0, momentum[2] = {0, 0}, momentum_scale = 0, kinetic = 0, internal = 0;
  };

  inline Totals
  totals(const State<2> &state)
  {
    Totals t;
    for (const whipple::MaterialState &material : state.material)
      for (Index c = 0; c < state.n_cells(); ++c)
        {
          t.mass += material.mass[c];
          t.internal += material.mass[c] * material.energy[c];
        }
    for (Index n = 0; n < state.n_nodes(); ++n)
      for (int d = 0; d < 2; ++d)
        {
          const double p = state.node_mass[n] * state.velocity[d][n];
          t.momentum[d] += p;
          t.momentum_scale += std::abs(p);
          t.kinetic += 0.5 * p * state.velocity[d][n];
        }
    return t;
  }

  /// One remap in alternating order.
  inline whipple::RemapSums<2>
  remap(whipple::DirectionalRemap<2> &remap, State<2> &state, const int first_axis)
  {
    remap.begin(state);
    whipple::RemapSums<2> report = remap.sweep(state, first_axis);
    report += remap.sweep(state, 1 - first_axis);
    remap.finish(state);
    return report;
  }

  /// Visit all pairs of arrays of two states that a sweep reads or writes: cell arrays, node arrays.
  template <class Cell, class Node>
  void
  visit(State<2> &a, State<2> &b, const Cell &cell, const Node &node)
  {
    cell(a.volume, b.volume);
    for (std::size_t m = 0; m < a.material.size(); ++m)
      {
        auto &p = a.material[m], &q = b.material[m];
        cell(p.volume, q.volume);
        cell(p.mass, q.mass);
        cell(p.density, q.density);
        cell(p.energy, q.energy);
        cell(p.void_fraction, q.void_fraction);
        for (int i = 0; i < 2; ++i)
          cell(p.fields[i].value, q.fields[i].value);
      }
    node(a.node_mass, b.node_mass);
    for (int d = 0; d < 2; ++d)
      {
        node(a.velocity[d], b.velocity[d]);
        node(a.position[d], b.position[d]);
      }
  }
  inline whipple::Boundaries<2>
  boundaries(const whipple::BoundaryKind kind)
  {
    whipple::Boundaries<2> result;
    for (auto &side : result)
      side.kind = kind;
    return result;
  }
} // namespace remap_case
