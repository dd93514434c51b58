// SPDX-License-Identifier: LGPL-2.1-or-later
#include "projection_fixture.h"

#include <whipple/error.h>

#include <gtest/gtest.h>

namespace
{
  using namespace whipple;
  using namespace whipple::projection_test;

  struct Case
  {
    Lattice<2>  grid;
    FlatMesh<2> mesh;
    State<2>    state;
    Random      random{7};

    explicit Case(Symmetry symmetry)
      : grid(lattice(symmetry, 6, 1))
      , mesh(mesh_of(grid, hanging_keys(grid)))
      , state(blank_state(mesh))
    {
      fill_randomly(state, random);
    }
  };

  Boundaries<2>
  reflecting_axis()
  {
    Boundaries<2> boundaries;
    boundaries[0].kind = BoundaryKind::reflecting;
    return boundaries;
  }
} // namespace

TEST(VelocityGather, NodesOfTheirOwnCornersStayTheSame)
{
  Case c(Symmetry::axisymmetric);
  ASSERT_GT(c.mesh.hanging.size(), 10u);
  set_velocities(c.mesh, c.state, 0.2, c.random);
  State<2>   again  = c.state;
  const auto report = gather_velocities<2>(c.mesh, {}, corner_velocities<2>(c.mesh, c.state), KineticLoss::heat, again);
  for (Index node = 0; node < c.mesh.n_nodes; ++node)
    for (int d = 0; d < 2; ++d)
      EXPECT_NEAR(again.velocity[d][node], c.state.velocity[d][node], 1e-14);
  EXPECT_NEAR(*report.converted, 0., 1e-14 * node_totals(c.state).kinetic_energy);
}

TEST(VelocityGather, RandomCornersKeepMomentumAndTotalEnergy)
{
  for (const Symmetry symmetry : {Symmetry::planar, Symmetry::axisymmetric})
    {
      Case                c(symmetry);
      CornerVelocities<2> corners(c.mesh.n_cells);
      for (auto &axis : corners.velocity)
        for (double &u : axis)
          u = c.random(-0.3, 0.7);
      ConservedTotals<2> before;
      for (Index cell = 0; cell < c.mesh.n_cells; ++cell)
        {
          corners.kinetic_remainder[cell] = cell_mass<2>(c.state, cell) * c.random(0., 0.01);
          before += cell_totals<2>(c.state, corners, cell);
        }
      const auto               report = gather_velocities<2>(c.mesh, {}, corners, KineticLoss::heat, c.state);
      const ConservedTotals<2> after  = node_totals(c.state);
      const double             energy = before.internal_energy + before.kinetic_energy;
      EXPECT_DOUBLE_EQ(after.mass, before.mass);
      EXPECT_NEAR(after.momentum[0], before.momentum[0], 1e-13 * before.mass);
      EXPECT_NEAR(after.momentum[1], before.momentum[1], 1e-13 * before.mass);
      EXPECT_NEAR(after.internal_energy + after.kinetic_energy, energy, 1e-13 * energy);
      EXPECT_GT(*report.converted, 0.);
      EXPECT_NEAR(*report.converted, before.kinetic_energy - after.kinetic_energy, 1e-13 * energy);
      EXPECT_NEAR(kinetic_energy<2>(c.mesh, c.state), after.kinetic_energy, 1e-13 * energy);
      EXPECT_NEAR(momentum<2>(c.mesh, c.state)[1], after.momentum[1], 1e-13 * before.mass);
    }
}

TEST(VelocityGather, NoCellIsCooled)
{
  Case                c(Symmetry::axisymmetric);
  CornerVelocities<2> corners(c.mesh.n_cells);
  for (auto &axis : corners.velocity)
    for (double &u : axis)
      u = c.random(-0.3, 0.7);
  const State<2> before = c.state;
  gather_velocities<2>(c.mesh, {}, corners, KineticLoss::heat, c.state);
  for (int m = 0; m < 2; ++m)
    for (Index cell = 0; cell < c.mesh.n_cells; ++cell)
      EXPECT_GE(c.state.material[m].energy[cell], before.material[m].energy[cell] - 1e-16);
}

TEST(VelocityGather, UniformVelocityKeepsItsBits)
{
  Case                c(Symmetry::axisymmetric);
  CornerVelocities<2> corners(c.mesh.n_cells);
  corners.velocity[1].assign(corners.velocity[1].size(), 0.6580123456789);
  const auto report = gather_velocities<2>(c.mesh, reflecting_axis(), corners, KineticLoss::heat, c.state);
  EXPECT_EQ(*report.converted, 0.);
  for (Index node = 0; node < c.mesh.n_nodes; ++node)
    if (c.state.node_mass[node] > 0)
      {
        EXPECT_EQ(c.state.velocity[1][node], 0.6580123456789);
      }
}

TEST(VelocityGather, ReflectingSideTakesTheNormalMomentum)
{
  Case                c(Symmetry::axisymmetric);
  CornerVelocities<2> corners(c.mesh.n_cells);
  for (auto &axis : corners.velocity)
    for (double &u : axis)
      u = c.random(-0.3, 0.7);
  ConservedTotals<2> before;
  for (Index cell = 0; cell < c.mesh.n_cells; ++cell)
    before += cell_totals<2>(c.state, corners, cell);
  const auto report = gather_velocities<2>(c.mesh, reflecting_axis(), corners, KineticLoss::heat, c.state);
  const auto after  = node_totals(c.state);
  for (Index node = 0; node < c.mesh.n_nodes; ++node)
    if (c.mesh.node_side[node] & 1)
      {
        EXPECT_EQ(c.state.velocity[0][node], 0.);
      }
  EXPECT_GT(std::abs(report.left->momentum[0]), 0.);
  EXPECT_EQ(report.left->momentum[1], 0.);
  EXPECT_NEAR(after.momentum[0] + report.left->momentum[0], before.momentum[0], 1e-13 * before.mass);
  EXPECT_NEAR(after.internal_energy + after.kinetic_energy, before.internal_energy + before.kinetic_energy,
              1e-13 * before.kinetic_energy);
}

TEST(CellPacket, PackAndUnpackReturnTheSameCell)
{
  Case c(Symmetry::axisymmetric);
  set_velocities(c.mesh, c.state, 0.2, c.random);
  const auto          layout = CellPacketLayout<2>::of(c.state);
  const auto          source = corner_velocities<2>(c.mesh, c.state);
  InterfaceNormals<2> normals(2);
  for (auto &material : normals)
    for (auto &component : material)
      component.assign(c.mesh.n_cells, 0.);

  State<2>            copy = blank_state(c.mesh);
  CornerVelocities<2> target(c.mesh.n_cells);
  for (Index cell = 0; cell < c.mesh.n_cells; ++cell)
    {
      const CellPacket packet = pack<2>(layout, c.state, cell, source, normals);
      EXPECT_EQ(packet.empty(), cell_mass<2>(c.state, cell) == 0);
      unpack<2>(layout, packet, copy, cell, target);
    }
  for (int m = 0; m < 2; ++m)
    {
      EXPECT_EQ(copy.material[m].volume, c.state.material[m].volume);
      EXPECT_EQ(copy.material[m].mass, c.state.material[m].mass);
      EXPECT_EQ(copy.material[m].density, c.state.material[m].density);
      EXPECT_EQ(copy.material[m].energy, c.state.material[m].energy);
      EXPECT_EQ(copy.material[m].void_fraction, c.state.material[m].void_fraction);
      for (int f = 0; f < 2; ++f)
        EXPECT_EQ(copy.material[m].fields[f].value, c.state.material[m].fields[f].value);
    }
  EXPECT_THROW(unpack<2>(layout, std::vector<double>(3, 0.), copy, 0, target), StateError);
}
