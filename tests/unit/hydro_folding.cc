// SPDX-License-Identifier: LGPL-2.1-or-later
// Elements that fold are found, and fragments stop at walls.
#include "hydro_case.h"
#include "projection_fixture.h"

#include <whipple/hydro/folding.h>
#include <whipple/hydro/fragment_release.h>
#include <whipple/hydro/lagrange_step.h>
#include <whipple/material/ideal_gas.h>

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
  EXPECT_EQ(release_fragments<2>(sheet.mesh, walls, sheet.state, 0.14).number, 0);
  const auto report = release_fragments<2>(sheet.mesh, walls, sheet.state, 0.16);
  EXPECT_EQ(report.number, 1);
  EXPECT_NEAR(report.booking.left->momentum[1], mass, 1e-15);
  EXPECT_EQ(report.booking.left->momentum[0], 0.);
  EXPECT_NEAR(*report.booking.converted, 0.5 * mass, 1e-15);
  EXPECT_NEAR(sheet.state.material[0].energy[c] - energy, 0.5, 1e-14);
  for (int k = 0; k < 4; ++k)
    {
      EXPECT_NEAR(sheet.state.velocity[0][sheet.mesh.cell_node[4 * c + k]], 0.3, 1e-15);
      EXPECT_EQ(sheet.state.velocity[1][sheet.mesh.cell_node[4 * c + k]], 0.);
    }
  EXPECT_EQ(release_fragments<2>(sheet.mesh, walls, sheet.state, 1.).number, 0); // it rests
}

TEST(FragmentRelease, WhatHasFoldedOnceStopsWhateverItsMotion)
{
  Sheet       sheet(Cohesion::fragments);
  const Index c = 4, n = sheet.mesh.cell_node[4 * c];
  sheet.state.velocity[0][n] = -0.01; // opens
  EXPECT_EQ(release_fragments<2>(sheet.mesh, {}, sheet.state, 0.1).number, 0);
  EXPECT_EQ(release_fragments<2>(sheet.mesh, {}, sheet.state, 0.1, std::array<Index, 1>{c}).number, 1);
  EXPECT_NEAR(sheet.state.velocity[0][n], -0.0025, 1e-17);
}

namespace
{
  /// Fragments of hot gas around a ring, each a slanted quadrilateral that flies as a whole.
  struct Ring
  {
    Lattice<2>            grid;
    FlatMesh<2>           mesh;
    std::vector<Material> materials;
    State<2>              state;

    explicit Ring(Symmetry symmetry)
      : grid{symmetry, {{0.5, -0.3}}, 0.1, {{4, 4}}, 0}
      , mesh(hydro_case::build(grid, hydro_case::uniform_keys(grid), Cohesion::fragments))
      , materials(1)
      , state()
    {
      materials[0].eos = std::make_shared<IdealGas>(1.4, 1.);
      state            = hydro_case::make_state(mesh, materials);
      for (Index c = 0; c < mesh.n_cells; ++c)
        for (int k = 0; k < 4; ++k)
          for (int d = 0; d < 2; ++d)
            {
              const Index n = mesh.cell_node[4 * c + k];
              state.position[d][n] += 0.01 * std::sin(3. * c + 5. * k + 7. * d);
              state.velocity[d][n] = 0.1 * std::cos(2. * c + d);
            }
      initialise_geometry(mesh, state);
      hydro_case::fill_all(state, 2., 1.5);
    }

    /// Sides and a diagonal of a fragment.
    std::vector<double>
    shape(Index c) const
    {
      std::vector<double> result;
      for (const auto &[a, b] : {std::pair(0, 1), std::pair(0, 2), std::pair(0, 3), std::pair(1, 2)})
        for (int d = 0; d < 2; ++d)
          result.push_back(state.position[d][mesh.cell_node[4 * c + b]] - state.position[d][mesh.cell_node[4 * c + a]]);
      return result;
    }
  };
} // namespace

TEST(RigidFragments, KeepTheirShapeAndWhatIsConserved)
{
  for (const Symmetry symmetry : {Symmetry::planar, Symmetry::axisymmetric})
    {
      Ring                          ring(symmetry);
      LagrangeStep<2>               step(ring.mesh, ring.materials, {}, {});
      std::vector<RigidFragment<2>> rigid;
      for (Index c = 0; c < ring.mesh.n_cells; c += 2)
        rigid.push_back({c, {false, false}});
      Derived derived;
      step.update_node_mass(ring.state);
      const auto before = hydro_case::totals(ring.state);
      const Ring start  = ring;
      double     dt     = 0;
      for (int i = 0; i < 8; ++i)
        {
          step.evaluate(ring.state, derived);
          dt = 0.25 * step.time_step(ring.state, derived).dt;
          step.advance(ring.state, derived, dt, rigid);
        }
      double change = 0;
      for (Index c = 0; c < ring.mesh.n_cells; ++c)
        for (std::size_t i = 0; i < 8; ++i)
          {
            const double part = std::abs(ring.shape(c)[i] - start.shape(c)[i]);
            if (c % 2 == 0)
              EXPECT_LT(part, 1e-14);
            else
              change = std::max(change, part);
          }
      EXPECT_GT(change, 0.01); // the others expand
      const auto after = hydro_case::totals(ring.state);
      EXPECT_NEAR(after.energy, before.energy, 1e-13 * before.energy);
      EXPECT_NEAR(after.momentum[1], before.momentum[1], 1e-13 * before.momentum_size[1]);
      // a ring of pressure p is driven outwards by 2 pi p times its area, whatever its shape
      const Index  n      = ring.mesh.cell_node[0];
      const double gained = ring.state.velocity[0][n] - start.state.velocity[0][n];
      if (symmetry == Symmetry::planar)
        EXPECT_NEAR(gained, 0., 1e-13);
      else
        EXPECT_GT(gained, 0.1 * dt);
    }
}

TEST(RigidFragments, WhatHoldsThemTakesTheirMomentum)
{
  Ring            ring(Symmetry::axisymmetric);
  LagrangeStep<2> step(ring.mesh, ring.materials, {}, {});
  for (int k = 0; k < 4; ++k)
    ring.state.velocity[0][ring.mesh.cell_node[k]] = 0.;
  Derived derived;
  step.update_node_mass(ring.state);
  step.evaluate(ring.state, derived);
  State<2> free = ring.state;
  // of one step of the same length with all rigid and none held: the momentum that the holder must take
  std::vector<RigidFragment<2>> rigid;
  for (Index c = 0; c < ring.mesh.n_cells; ++c)
    rigid.push_back({c, {false, false}});
  const double dt = step.time_step(free, derived).dt;
  EXPECT_EQ(step.advance(free, derived, dt, rigid).boundary_momentum[0], 0.);
  double gained = 0;
  for (int k = 0; k < 4; ++k)
    gained += free.node_mass[ring.mesh.cell_node[k]] * free.velocity[0][ring.mesh.cell_node[k]];
  rigid[0].held     = {true, false};
  const auto report = step.advance(ring.state, derived, dt, rigid);
  EXPECT_GT(gained, 1e-3);
  EXPECT_NEAR(report.boundary_momentum[0], -gained, 1e-13 * gained);
  EXPECT_EQ(report.boundary_work, 0.);
  for (int k = 0; k < 4; ++k)
    EXPECT_EQ(ring.state.velocity[0][ring.mesh.cell_node[k]], 0.);
}

TEST(FragmentRelease, NamesThoseThatKeepTheirShape)
{
  Sheet         sheet(Cohesion::fragments);
  RigidWalls<2> walls;
  walls.there[3]    = true;
  walls.position[3] = 0.05;
  for (int k = 0; k < 4; ++k)
    sheet.state.velocity[1][sheet.mesh.cell_node[4 * 4 + k]] = 1.; // goes through the wall
  const auto report = release_fragments<2>(sheet.mesh, walls, sheet.state, 0.16, std::array<Index, 2>{1, 2});
  ASSERT_EQ(report.rigid.size(), 3u);
  for (std::size_t i = 0; i < 3; ++i)
    {
      EXPECT_EQ(report.rigid[i].cell, (std::array<Index, 3>{1, 2, 4})[i]);
      EXPECT_EQ(report.rigid[i].held[1], i == 2);
      EXPECT_FALSE(report.rigid[i].held[0]);
    }
}

TEST(RigidFragments, SliversAreFoundAndSetNoTimeStep)
{
  for (const Symmetry symmetry : {Symmetry::planar, Symmetry::axisymmetric})
    {
      Ring            ring(symmetry);
      LagrangeStep<2> step(ring.mesh, ring.materials, {}, {});
      Derived         derived;
      step.update_node_mass(ring.state);
      step.evaluate(ring.state, derived);
      const double plain = step.time_step(ring.state, derived).dt;
      const Index  thin = 5, small = 9;
      const auto   shrink = [&](Index c, double along, double across) {
        const Index *node = &ring.mesh.cell_node[4 * c];
        for (int k = 1; k < 4; ++k)
          for (int d = 0; d < 2; ++d)
            ring.state.position[d][node[k]] =
                ring.state.position[d][node[0]] + 0.1 * (k >> d & 1) * (d == 0 ? along : across);
      };
      shrink(thin, 1., 0.03);    // 33 : 1
      shrink(small, 0.02, 0.02); // no sliver, though it sets as small a step
      initialise_geometry(ring.mesh, ring.state);
      hydro_case::fill_all(ring.state, 2., 1.5);
      step.evaluate(ring.state, derived);
      EXPECT_EQ(step.time_step(ring.state, derived).cell, small);
      EXPECT_EQ(step.slivers(ring.state, derived, 0.1 * plain), std::vector<Index>{thin});
      EXPECT_TRUE(step.slivers(ring.state, derived, 0.01 * plain).empty());
      EXPECT_EQ(step.time_step(ring.state, derived, std::array<Index, 1>{small}).cell, thin);
      EXPECT_GT(step.time_step(ring.state, derived, std::array<Index, 2>{thin, small}).dt, 0.5 * plain);
    }
}
