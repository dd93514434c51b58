// SPDX-License-Identifier: LGPL-2.1-or-later
#include "../figure.h"
#include "projection_fixture.h"

#include <whipple/remap/cell_split.h>
#include <whipple/remap/child_volumes.h>
#include <whipple/remap/interface_normal.h>

#include <gtest/gtest.h>

#include <numeric>

namespace
{
  using namespace whipple;
  using namespace whipple::projection_test;

  /// A mesh and what it holds, with the steps of a regrid.
  struct Grid
  {
    Lattice<2>  lattice;
    FlatMesh<2> mesh;
    State<2>    state;

    Grid(const Lattice<2> &grid, std::vector<CellKey> keys)
      : lattice(grid)
      , mesh(mesh_of(grid, std::move(keys)))
      , state(blank_state(mesh))
    {
    }

    std::vector<CellPacket>
    packets() const
    {
      const auto              layout     = CellPacketLayout<2>::of(state);
      const auto              velocities = corner_velocities<2>(mesh, state);
      const auto              normals    = interface_normals<2>(mesh, state);
      std::vector<CellPacket> result;
      for (Index cell = 0; cell < mesh.n_cells; ++cell)
        result.push_back(pack<2>(layout, state, cell, velocities, normals));
      return result;
    }

    void
    take(const std::vector<CellPacket> &packets)
    {
      const auto          layout = CellPacketLayout<2>::of(state);
      CornerVelocities<2> corners(mesh.n_cells);
      for (Index cell = 0; cell < mesh.n_cells; ++cell)
        unpack<2>(layout, packets[cell], state, cell, corners);
      gather_velocities<2>(mesh, {}, corners, KineticLoss::heat, state);
    }
  };

  void
  expect_same(const ConservedTotals<2> &a, const ConservedTotals<2> &b, double tolerance)
  {
    const double energy = a.internal_energy + a.kinetic_energy;
    EXPECT_NEAR(a.mass, b.mass, tolerance * a.mass);
    EXPECT_NEAR(a.momentum[0], b.momentum[0], tolerance * std::abs(a.momentum[1]));
    EXPECT_NEAR(a.momentum[1], b.momentum[1], tolerance * std::abs(a.momentum[1]));
    EXPECT_NEAR(energy, b.internal_energy + b.kinetic_energy, tolerance * energy);
  }

  /// Refine the cells that `choose` picks, with all the steps of a regrid.
  template <typename Choose>
  Grid
  refine(const Grid &coarse, Choose choose)
  {
    const CellSplit<2>      remap(coarse.lattice, CellPacketLayout<2>::of(coarse.state));
    std::vector<CellKey>    keys;
    std::vector<CellPacket> packets;
    const auto              from = coarse.packets();
    for (Index cell = 0; cell < coarse.mesh.n_cells; ++cell)
      if (choose(cell))
        {
          for (const CellKey key : children_keys(coarse.lattice, coarse.mesh.key[cell]))
            keys.push_back(key);
          for (const CellPacket &child : remap.split(coarse.mesh.key[cell], from[cell]))
            packets.push_back(child);
        }
      else
        {
          keys.push_back(coarse.mesh.key[cell]);
          packets.push_back(from[cell]);
        }
    Grid fine(coarse.lattice, keys);
    fine.take(packets);
    return fine;
  }

  /// Undo refine(): cells above level 0 come in groups of four.
  Grid
  coarsen(const Grid &fine)
  {
    const CellSplit<2>      remap(fine.lattice, CellPacketLayout<2>::of(fine.state));
    std::vector<CellKey>    keys;
    std::vector<CellPacket> packets;
    const auto              from = fine.packets();
    for (Index cell = 0; cell < fine.mesh.n_cells; ++cell)
      if (fine.mesh.level[cell] == 0)
        {
          keys.push_back(fine.mesh.key[cell]);
          packets.push_back(from[cell]);
        }
      else
        {
          keys.push_back(make_key<2>(0, key_point<2>(fine.mesh.key[cell])));
          packets.push_back(remap.merge(keys.back(), {from[cell], from[cell + 1], from[cell + 2], from[cell + 3]}));
          cell += 3;
        }
    Grid coarse(fine.lattice, keys);
    coarse.take(packets);
    return coarse;
  }
} // namespace

TEST(CellSplit, RefinedAndCoarsenedAThousandTimes)
{
  Random     random(11);
  const auto grid = lattice(Symmetry::axisymmetric, 6, 1);
  Grid       g(grid, uniform_keys(grid, 0));
  fill_randomly(g.state, random);
  set_velocities(g.mesh, g.state, 0.2, random);
  const ConservedTotals<2> start = node_totals(g.state);
  for (int i = 0; i < 1000; ++i)
    {
      std::vector<bool> chosen(g.mesh.n_cells);
      for (auto cell : chosen)
        cell = random(0., 1.) < 0.4;
      g = coarsen(refine(g, [&](Index cell) { return chosen[cell]; }));
    }
  const ConservedTotals<2> end = node_totals(g.state);
  expect_same(start, end, 1e-12);
  figure::record("1000 regrids: mass, relative change", end.mass / start.mass - 1., "<= 1e-12");
  figure::record("1000 regrids: axial momentum, relative change", end.momentum[1] / start.momentum[1] - 1., "<= 1e-12");
  figure::record("1000 regrids: total energy, relative change", end.total_energy() / start.total_energy() - 1.,
                 "<= 1e-12");
  EXPECT_LE(end.kinetic_energy, start.kinetic_energy * (1. + 1e-12));
}

TEST(CellSplit, PacketsAloneKeepTotalsThroughAThousandCycles)
{
  Random     random(12);
  const auto grid   = lattice(Symmetry::axisymmetric, 2, 1);
  const auto layout = [&] {
    const auto mesh = mesh_of(grid, uniform_keys(grid, 0));
    return CellPacketLayout<2>::of(blank_state(mesh));
  }();
  const CellSplit<2> remap(grid, layout);
  const CellKey      key = make_key<2>(0, {{0, 2}}); // at the axis
  Grid               g(grid, {key});
  set_material(g.state.material[0], 0, 0.4 * g.state.volume[0], 2.7, 0.01, 0.);
  set_material(g.state.material[1], 0, 0.3 * g.state.volume[0], 1.2, 0.02, 0.5);
  set_velocities(g.mesh, g.state, 0.3, random);
  CellPacket   packet            = g.packets()[0];
  const double half              = std::sqrt(0.5);
  packet[layout.normal(0, 0)]    = half;
  packet[layout.normal(0, 1)]    = half;
  packet[layout.normal(1, 0)]    = -0.6;
  packet[layout.normal(1, 1)]    = -0.8;
  const ConservedTotals<2> start = node_totals(g.state);
  for (int i = 0; i < 1000; ++i)
    packet = remap.merge(key, remap.split(key, packet));
  CornerVelocities<2> corners(1);
  unpack<2>(layout, packet, g.state, 0, corners);
  expect_same(start, cell_totals<2>(g.state, corners, 0), 1e-12);
  EXPECT_NEAR(packet[layout.volume(0)], 0.4 * g.state.volume[0], 1e-12 * g.state.volume[0]);
  EXPECT_GE(corners.kinetic_remainder[0], 0.);
}

TEST(CellSplit, UniformVelocityAndValuesKeepTheirBits)
{
  Random     random(13);
  const auto grid = lattice(Symmetry::axisymmetric, 4, 1);
  Grid       g(grid, uniform_keys(grid, 0));
  for (Index cell = 0; cell < g.mesh.n_cells; ++cell)
    set_material(g.state.material[0], cell, random(0.1, 1.) * g.state.volume[cell], 2.703, 0.0123, 0.25);
  CornerVelocities<2> uniform(g.mesh.n_cells);
  uniform.velocity[1].assign(uniform.velocity[1].size(), 0.658);
  gather_velocities<2>(g.mesh, {}, uniform, KineticLoss::heat, g.state);

  const Grid fine = refine(g, [](Index cell) { return cell % 2 == 0; });
  const Grid back = coarsen(fine);
  for (const Grid *result : {&fine, &back})
    {
      for (Index cell = 0; cell < result->mesh.n_cells; ++cell)
        if (result->state.material[0].mass[cell] > 0)
          {
            EXPECT_EQ(result->state.material[0].density[cell], 2.703);
            EXPECT_EQ(result->state.material[0].energy[cell], 0.0123);
            EXPECT_EQ(result->state.material[0].void_fraction[cell], 0.25);
          }
      for (Index node = 0; node < result->mesh.n_nodes; ++node)
        if (result->state.node_mass[node] > 0)
          {
            EXPECT_EQ(result->state.velocity[1][node], 0.658);
          }
    }
}

TEST(CellSplit, LinearVelocitySurvivesRefinement)
{
  const auto grid = lattice(Symmetry::planar, 2, 1);
  Grid       g(grid, uniform_keys(grid, 0));
  for (Index cell = 0; cell < g.mesh.n_cells; ++cell)
    set_material(g.state.material[0], cell, g.state.volume[cell], 2.7, 0.01, 0.);
  const auto field = [](const FlatMesh<2> &mesh, Index node) {
    return 0.3 + 0.5 * mesh.node_point[0][node] - 0.7 * mesh.node_point[1][node];
  };
  CornerVelocities<2> corners(g.mesh.n_cells);
  for (Index i = 0; i < g.mesh.n_cells * 4; ++i)
    corners.velocity[0][i] = field(g.mesh, g.mesh.cell_node[i]);
  gather_velocities<2>(g.mesh, {}, corners, KineticLoss::heat, g.state);
  const Grid fine = refine(g, [](Index) { return true; });
  for (Index node = 0; node < fine.mesh.n_nodes; ++node)
    EXPECT_NEAR(fine.state.velocity[0][node], field(fine.mesh, node), 1e-15);
}

TEST(ChildVolumes, InterfaceCellsAreCutAlongTheirPlane)
{
  // lower half full: the lower children get everything
  const Vector<2> lower{{0., 0.}};
  const auto      share = child_shares<2>(Symmetry::axisymmetric, lower, 0.2,
                                     {{0.5 * child_volumes<2>(Symmetry::axisymmetric, lower, 0.4)[0], {{0., 1.}}}});
  EXPECT_NEAR(share[0][2] + share[0][3], 0., 1e-12);
  EXPECT_NEAR(share[0][0], 0.25, 1e-12); // first ring holds a quarter of the disc
}

TEST(ChildVolumes, NoChildIsOverfilled)
{
  Random random(14);
  for (int i = 0; i < 1000; ++i)
    {
      const Vector<2>                lower{{i % 2 ? 0. : random(0., 2.), random(-1., 1.)}};
      const auto                     room = child_volumes<2>(Symmetry::axisymmetric, lower, 0.3);
      const double                   cell = std::accumulate(room.begin(), room.end(), 0.), filled = random(0., 1.);
      double                         rest = filled * cell;
      std::vector<MaterialInCell<2>> materials(3);
      for (int m = 0; m < 3; ++m)
        {
          const double angle  = random(0., 6.3);
          materials[m].volume = m == 2 ? rest : rest * random(0., 1.);
          materials[m].normal = {{std::cos(angle), std::sin(angle)}};
          rest -= materials[m].volume;
        }
      const auto share = child_shares<2>(Symmetry::axisymmetric, lower, 0.3, materials);
      for (int m = 0; m < 3; ++m)
        EXPECT_NEAR(std::accumulate(share[m].begin(), share[m].end(), 0.), 1., 1e-14);
      for (int c = 0; c < 4; ++c)
        {
          double sum = 0;
          for (int m = 0; m < 3; ++m)
            sum += share[m][c] * materials[m].volume;
          EXPECT_LE(sum, room[c] + 2e-12 * cell);
        }
    }
}
