// SPDX-License-Identifier: LGPL-2.1-or-later
// Elements that fold are found, and fragments stop at walls.
#include "projection_fixture.h"

#include <whipple/hydro/folding.h>
#include <whipple/hydro/fragment_release.h>

#include <gtest/gtest.h>

namespace
{
  using namespace whipple;
  using namespace whipple::projection_test;

  struct Sheet
  {
    Lattice<2>  grid = lattice(Symmetry::planar, 3, 0);
    FlatMesh<2> mesh;
    State<2>    state;

    explicit Sheet(const Bonds &bonds)
      : mesh(mesh_of(grid, uniform_keys(grid, 0), bonds))
      , state(blank_state(mesh))
    {
      for (Index c = 0; c < mesh.n_cells; ++c)
        set_material(state.material[0], c, state.volume[c], 2.7, 0.01, 0.);
      gather_velocities<2>(mesh, {}, CornerVelocities<2>(mesh.n_cells), KineticLoss::drop, state);
    }
  };
} // namespace

TEST(Folding, IsSeenAheadAndAfterwards)
{
  Sheet sheet(Cohesion::bonded);
  // corner 3 of the middle cell moves towards corner 2 and past it, one edge of 0.1 cm away: its sides and those of the
  // cell above cross
  const Index n              = sheet.mesh.cell_node[4 * 4 + 3];
  sheet.state.velocity[0][n] = -1.;
  EXPECT_TRUE(folding_cells(sheet.mesh, sheet.state, 0.0999).empty());
  EXPECT_EQ(folding_cells(sheet.mesh, sheet.state, 0.1001), (std::vector<Index>{4, 7}));
  for (const auto &[moved, number] : {std::pair(0.0999, 0), std::pair(0.1001, 2)})
    {
      sheet.state.position[0][n] = sheet.mesh.node_point[0][n] - moved;
      EXPECT_EQ(folded_cells(sheet.mesh, sheet.state).size(), std::size_t(number)) << moved;
    }
  sheet.state.material[0].mass[4] = sheet.state.material[0].mass[7] = 0; // nothing there to fold
  EXPECT_TRUE(folded_cells(sheet.mesh, sheet.state).empty());
  EXPECT_TRUE(folding_cells(sheet.mesh, sheet.state, 0.).empty());
}

TEST(Folding, AnArrowheadCoversWhatItIsTakenToHave)
{
  Sheet       sheet(Cohesion::bonded);
  const Index n = sheet.mesh.cell_node[4 * 4 + 3];
  for (int d = 0; d < 2; ++d) // three quarters of the way to corner 0: reflex, but no sides cross
    sheet.state.position[d][n] -= 0.075;
  EXPECT_TRUE(folded_cells(sheet.mesh, sheet.state).empty());
  for (int d = 0; d < 2; ++d) // past it: turned over
    sheet.state.position[d][n] -= 0.05;
  EXPECT_EQ(folded_cells(sheet.mesh, sheet.state), std::vector<Index>{4});
}

TEST(FragmentRelease, AFragmentStopsAtAWallThatTakesItsMomentum)
{
  Sheet         sheet(Cohesion::fragments);
  RigidWalls<2> walls;
  walls.there[3]    = true;
  walls.position[3] = 0.05;
  const Index c     = 4; // from z = -0.2 to -0.1 cm
  for (int k = 0; k < 4; ++k)
    {
      sheet.state.velocity[0][sheet.mesh.cell_node[4 * c + k]] = 0.3;
      sheet.state.velocity[1][sheet.mesh.cell_node[4 * c + k]] = 1.;
    }
  const double mass = sheet.state.material[0].mass[c], energy = sheet.state.material[0].energy[c];
  EXPECT_EQ(release_fragments<2>(sheet.mesh, walls, sheet.state, 0.14).released, 0);
  const auto report = release_fragments<2>(sheet.mesh, walls, sheet.state, 0.16);
  EXPECT_EQ(report.released, 1);
  EXPECT_NEAR(report.wall_impulse[1], mass, 1e-15);
  EXPECT_EQ(report.wall_impulse[0], 0.);
  EXPECT_NEAR(report.kinetic_loss, 0.5 * mass, 1e-15);
  EXPECT_NEAR(sheet.state.material[0].energy[c] - energy, 0.5, 1e-14);
  for (int k = 0; k < 4; ++k)
    {
      EXPECT_NEAR(sheet.state.velocity[0][sheet.mesh.cell_node[4 * c + k]], 0.3, 1e-15);
      EXPECT_EQ(sheet.state.velocity[1][sheet.mesh.cell_node[4 * c + k]], 0.);
    }
  EXPECT_EQ(release_fragments<2>(sheet.mesh, walls, sheet.state, 1.).released, 0); // it rests
}

TEST(FragmentRelease, WhatHasFoldedOnceStopsWhateverItsMotion)
{
  Sheet       sheet(Cohesion::fragments);
  const Index c = 4, n = sheet.mesh.cell_node[4 * c];
  sheet.state.velocity[0][n] = -0.01; // opens
  EXPECT_EQ(release_fragments<2>(sheet.mesh, {}, sheet.state, 0.1).released, 0);
  EXPECT_EQ(release_fragments<2>(sheet.mesh, {}, sheet.state, 0.1, std::array<Index, 1>{c}).released, 1);
  EXPECT_NEAR(sheet.state.velocity[0][n], -0.0025, 1e-17);
}
