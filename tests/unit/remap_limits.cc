// SPDX-License-Identifier: LGPL-2.1-or-later
#include "remap_case.h"

#include <whipple/error.h>

#include <gtest/gtest.h>

#include <random>

namespace
{
  using namespace remap_case;
  using whipple::BoundaryKind;

  /// All cells full of the same, nodes at random velocities of a given size; a piston drives the lower side of axis 0.
  State<2>
  moving_block(const Mesh &mesh, const double size, const double dt, const double piston)
  {
    std::mt19937                           random(11);
    std::uniform_real_distribution<double> unit(-size, size);
    State<2>                               state = empty_state(mesh, 1);
    for (Index n = 0; n < mesh.n_nodes; ++n)
      for (int d = 0; d < 2; ++d)
        state.velocity[d][n] = mesh.node_side[n] & 1 ? (d == 0 ? piston : 0.) : unit(random);
    lump(mesh, state);
    move_nodes(mesh, state, dt);
    whipple::MaterialState &m = state.material[0];
    m.volume                  = state.volume;
    m.density.assign(mesh.n_cells, 2.7);
    m.energy.assign(mesh.n_cells, 0.02);
    for (Index c = 0; c < mesh.n_cells; ++c)
      m.mass[c] = 2.7 * m.volume[c];
    lump(mesh, state);
    return state;
  }
} // namespace

TEST(RemapLimits, TimeStepKeepsNodesWithinTheirCells)
{
  const Mesh mesh =
      graded_mesh({Symmetry::planar, {0., 0.}, 0.01, {4, 4}, 2}, [](const Point &x) { return std::hypot(x[0], x[1]); });
  State<2>                     state = empty_state(mesh, 1);
  whipple::DirectionalRemap<2> remap(mesh, boundaries(BoundaryKind::transmitting), {});
  EXPECT_TRUE(std::isinf(remap.time_step(state).dt));
  state.velocity[0][mesh.cell_node[0]] = -0.5;
  EXPECT_DOUBLE_EQ(remap.time_step(state).dt, 0.45 * mesh.size[0] / 0.5);
}

TEST(RemapLimits, TooLongAStepIsATypedError)
{
  const Mesh                   mesh = uniform_mesh(Symmetry::planar, 0.01, {8, 8});
  whipple::DirectionalRemap<2> remap(mesh, boundaries(BoundaryKind::transmitting), {});
  State<2>                     state = moving_block(mesh, 0., 0., 0.);
  for (double &x : state.position[0])
    x += 0.0101;
  remap.begin(state);
  EXPECT_THROW(remap.sweep(state, 0), whipple::StateError);
}

TEST(RemapLimits, MaterialMayNotLeaveTheActiveRegion)
{
  // the upper half of the domain is not active
  const Lattice                 lattice{Symmetry::planar, {0., 0.}, 0.01, {4, 8}, 0};
  std::vector<whipple::CellKey> keys;
  for (int j = 0; j < 4; ++j)
    for (int i = 0; i < 4; ++i)
      keys.push_back(whipple::make_key<2>(0, {i, j}));
  const Mesh mesh =
      whipple::build_flat_mesh<2>(lattice, keys, 16, std::vector<std::uint8_t>(16, 0), 0, whipple::Cohesion::bonded);
  whipple::DirectionalRemap<2> remap(mesh, boundaries(BoundaryKind::transmitting), {});
  State<2>                     state = moving_block(mesh, 0., 0., 0.);
  for (double &y : state.position[1])
    y += 0.001;
  remap.begin(state);
  EXPECT_THROW(remap.sweep(state, 1), whipple::StateError);
}

TEST(RemapLimits, DroppedKineticEnergyLeavesTheMaterialCold)
{
  const Mesh               mesh = uniform_mesh(Symmetry::planar, 0.01, {8, 8});
  whipple::RemapParameters parameters;
  parameters.kinetic_loss_to_heat = false;
  whipple::DirectionalRemap<2> remap(mesh, boundaries(BoundaryKind::transmitting), parameters);
  State<2>                     state  = moving_block(mesh, 0.5, 0.003, 0.);
  const whipple::RemapSums<2>  report = remap_case::remap(remap, state, 0);
  EXPECT_GT(report.kinetic_lost, 0.);
  EXPECT_EQ(report.kinetic_heated, 0.);
  for (const double energy : state.material[0].energy)
    EXPECT_EQ(energy, 0.02);
}

TEST(RemapLimits, PistonKeepsItsVelocityAndItsWorkIsBooked)
{
  const Mesh             mesh  = uniform_mesh(Symmetry::planar, 0.01, {8, 8});
  whipple::Boundaries<2> sides = boundaries(BoundaryKind::transmitting);
  sides[0].kind                = BoundaryKind::inflow;
  sides[0].velocity            = {0.4, 0.};
  whipple::DirectionalRemap<2> remap(mesh, sides, {});
  State<2>                     state  = moving_block(mesh, 0.5, 0.003, 0.4);
  const Totals                 before = totals(state);
  const whipple::RemapSums<2>  report = remap_case::remap(remap, state, 1);
  const Totals                 after  = totals(state);
  for (Index n = 0; n < mesh.n_nodes; ++n)
    if (mesh.node_side[n] & 1)
      {
        EXPECT_NEAR(state.velocity[0][n], 0.4, 1e-16);
      }
  whipple::SideFlux<2> left;
  for (const whipple::SideFlux<2> &side : report.side)
    {
      left.mass += side.mass;
      left.kinetic += side.kinetic;
      left.internal += side.internal;
      for (int d = 0; d < 2; ++d)
        left.momentum[d] += side.momentum[d];
    }
  EXPECT_LT(report.side[0].mass, 0.);
  EXPECT_NEAR(after.mass + left.mass, before.mass, 1e-14 * before.mass);
  for (int d = 0; d < 2; ++d)
    EXPECT_NEAR(after.momentum[d] + left.momentum[d], before.momentum[d], 1e-13 * before.momentum_scale);
  EXPECT_NEAR(after.kinetic + left.kinetic + report.kinetic_lost, before.kinetic, 1e-13 * before.kinetic);
  EXPECT_NEAR(after.internal + left.internal - report.kinetic_heated, before.internal, 1e-13 * before.internal);
}

TEST(RemapLimits, CrumbsDoNotShrinkToNothing)
{
  // a block of cells that hold next to nothing, swept back and forth: handed on, shares of shares would reach
  // denormal numbers and 0 / 0
  const Mesh                   mesh = uniform_mesh(Symmetry::planar, 0.01, {8, 8});
  whipple::DirectionalRemap<2> remap(mesh, boundaries(BoundaryKind::transmitting), {});
  for (const double share : {1e-20, 1e-100, 1e-290})
    {
      State<2>                state = moving_block(mesh, 1e-9, 0.003, 0.);
      whipple::MaterialState &m     = state.material[0];
      for (Index c = 0; c < mesh.n_cells; ++c)
        if (mesh.lower[1][c] > 0.025)
          {
            m.volume[c] *= share;
            m.mass[c] *= share;
          }
      lump(mesh, state);
      for (int step = 0; step < 20; ++step)
        {
          for (int d = 0; d < 2; ++d)
            state.position[d] = mesh.node_point[d];
          move_nodes(mesh, state, step % 2 ? 0.003 : -0.003);
          remap_case::remap(remap, state, step % 2);
          for (Index c = 0; c < mesh.n_cells; ++c)
            {
              ASSERT_TRUE(std::isfinite(m.mass[c])) << "share " << share << ", step " << step;
              ASSERT_NEAR(m.density[c], m.mass[c] > 0 ? 2.7 : 0., 1e-3) << "share " << share << ", step " << step;
            }
        }
    }
}
