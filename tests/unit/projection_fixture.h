// SPDX-License-Identifier: LGPL-2.1-or-later
#pragma once

#include <whipple/mesh/flat_builder.h>
#include <whipple/projection/cell_totals.h>
#include <whipple/state/packet_layout.h>
#include <whipple/state/velocity_gather.h>

#include <random>

/// Small meshes and random states for the tests of packets, refinement and projections.
namespace whipple::projection_test
{
  inline Lattice<2>
  lattice(Symmetry symmetry, int roots, int max_level)
  {
    Lattice<2> result;
    result.symmetry  = symmetry;
    result.origin    = {{0., -0.3}};
    result.max_level = max_level;
    result.roots     = {{roots, roots}};
    result.spacing   = 0.1 / (1 << max_level);
    return result;
  }

  /// All cells of one level.
  inline std::vector<CellKey>
  uniform_keys(const Lattice<2> &lattice, int level)
  {
    std::vector<CellKey> keys;
    for (int j = 0; j < lattice.roots[1] << level; ++j)
      for (int i = 0; i < lattice.roots[0] << level; ++i)
        keys.push_back(make_key<2>(level, {{i * lattice.extent(level), j * lattice.extent(level)}}));
    return keys;
  }

  inline std::vector<CellKey>
  children_keys(const Lattice<2> &lattice, CellKey parent)
  {
    std::vector<CellKey> keys;
    const int            level = key_level(parent) + 1;
    for (int c = 0; c < 4; ++c)
      {
        LatticePoint<2> point = key_point<2>(parent);
        for (int d = 0; d < 2; ++d)
          if (c >> d & 1)
            point[d] += lattice.extent(level);
        keys.push_back(make_key<2>(level, point));
      }
    return keys;
  }

  /// Level 0 with some cells refined once: a mesh with hanging nodes.
  inline std::vector<CellKey>
  hanging_keys(const Lattice<2> &lattice)
  {
    std::vector<CellKey> keys;
    int                  count = 0;
    for (const CellKey key : uniform_keys(lattice, 0))
      if (count++ % 3 == 1)
        for (const CellKey child : children_keys(lattice, key))
          keys.push_back(child);
      else
        keys.push_back(key);
    return keys;
  }

  inline FlatMesh<2>
  mesh_of(const Lattice<2> &lattice, std::vector<CellKey> keys, const Bonds &bonds = Cohesion::bonded)
  {
    const Index               n = static_cast<Index>(keys.size());
    std::vector<std::uint8_t> layer(n, 0);
    return build_flat_mesh<2>(lattice, std::move(keys), n, std::move(layer), 1, bonds);
  }

  /// Zero state with two materials, voids in both, a mass-carried and a volume-carried field.
  inline State<2>
  blank_state(const FlatMesh<2> &mesh)
  {
    State<2> like;
    like.material.resize(2);
    for (MaterialState &material : like.material)
      {
        material.void_fraction = {0.};
        material.fields        = {{{"plastic strain", "1", Carrier::mass}, {}},
                                  {{"deviatoric stress", "Mbar", Carrier::volume}, {}}};
      }
    return empty_state_like<2>(like, mesh);
  }

  class Random
  {
  public:
    explicit Random(unsigned seed)
      : engine_(seed)
    {
    }
    double
    operator()(double low, double high)
    {
      return std::uniform_real_distribution<double>(low, high)(engine_);
    }

  private:
    std::mt19937 engine_;
  };

  inline void
  set_material(MaterialState &material, Index cell, double volume, double density, double energy, double phi)
  {
    material.volume[cell]          = volume;
    material.density[cell]         = density;
    material.mass[cell]            = density * volume;
    material.energy[cell]          = energy;
    material.void_fraction[cell]   = phi;
    material.fields[0].value[cell] = 3. * energy;
    material.fields[1].value[cell] = phi - energy;
  }

  /// Materials of impact-like size in every cell, some cells partly filled or empty.
  inline void
  fill_randomly(State<2> &state, Random &random)
  {
    for (Index cell = 0; cell < state.n_cells(); ++cell)
      {
        const double kind = random(0., 1.);
        if (kind < 0.15)
          continue;
        const double filled = kind < 0.5 ? 1. : random(0.01, 1.), first = random(0., 1.) < 0.5 ? 1. : random(0., 1.);
        for (int m = 0; m < 2; ++m)
          {
            const double fraction = filled * (m == 0 ? first : 1. - first), phi = random(0., 0.9);
            if (fraction > 0)
              set_material(state.material[m], cell, fraction * state.volume[cell], (1. - phi) * random(2., 4.),
                           random(0., 0.02), phi);
          }
      }
  }

  /// Both materials in every cell, with the same share of voids, filling it.
  inline void
  fill_with_both(State<2> &state, Random &random)
  {
    for (Index cell = 0; cell < state.n_cells(); ++cell)
      {
        const double phi = random(0., 0.9), share = random(0., 1.);
        set_material(state.material[0], cell, share * state.volume[cell], (1. - phi) * 2.75, random(0., 0.02), phi);
        set_material(state.material[1], cell, (1. - share) * state.volume[cell], (1. - phi) * 7.9, random(0., 0.02),
                     phi);
      }
  }

  /// Node velocities near 0.6 cm/us towards +z with some scatter, made consistent with masses and hanging nodes.
  inline void
  set_velocities(const FlatMesh<2> &mesh, State<2> &state, double scatter, Random &random)
  {
    CornerVelocities<2>    corners(mesh.n_cells);
    std::vector<Vector<2>> node(mesh.n_nodes);
    for (auto &v : node)
      v = {{scatter * random(-1., 1.), 0.6 + scatter * random(-1., 1.)}};
    for (Index i = 0; i < mesh.n_cells * 4; ++i)
      for (int d = 0; d < 2; ++d)
        corners.velocity[d][i] = node[mesh.cell_node[i]][d];
    gather_velocities<2>(mesh, Boundaries<2>{}, corners, KineticLoss::drop, state);
  }

  /// Totals from the nodes: independent of corner bookkeeping.
  inline ConservedTotals<2>
  node_totals(const State<2> &state)
  {
    ConservedTotals<2> totals;
    for (const MaterialState &material : state.material)
      for (Index cell = 0; cell < state.n_cells(); ++cell)
        {
          totals.mass += material.mass[cell];
          totals.internal_energy += material.mass[cell] * material.energy[cell];
        }
    for (Index node = 0; node < state.n_nodes(); ++node)
      for (int d = 0; d < 2; ++d)
        {
          totals.momentum[d] += state.node_mass[node] * state.velocity[d][node];
          totals.kinetic_energy += 0.5 * state.node_mass[node] * state.velocity[d][node] * state.velocity[d][node];
        }
    return totals;
  }
} // namespace whipple::projection_test
