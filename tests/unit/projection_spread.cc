// SPDX-License-Identifier: LGPL-2.1-or-later
// Solid that does not fit into its cell is moved to where there is room, and nothing is squeezed.
#include "../figure.h"
#include "projection_fixture.h"

#include <whipple/projection/spread_excess.h>

#include <gtest/gtest.h>

namespace
{
  using namespace whipple;
  using namespace whipple::projection_test;
  using namespace whipple::projection;

  /// Cells with something laid down on them, random or by hand.
  struct Pile
  {
    FlatMesh<2>               mesh;
    State<2>                  state; ///< what was there before
    Laid                      laid;
    std::vector<std::uint8_t> closed;

    Pile(const Lattice<2> &grid, std::vector<CellKey> keys)
      : mesh(mesh_of(grid, std::move(keys)))
      , state(blank_state(mesh))
      , laid{blank_state(mesh).material, std::vector<Motion>(mesh.n_cells)}
    {
    }

    /// Lay down so many cell volumes, half of material 1, with pores.
    void
    put(Index cell, double fill, double phi, const Vector<2> &velocity, double kinetic_per_gram)
    {
      for (int m = 0; m < 2; ++m)
        set_material(laid.material[m], cell, 0.5 * fill * state.volume[cell], (1. - phi) * (m ? 7.9 : 2.75),
                     0.01 * (1 + m), phi);
      Motion &motion = laid.motion[cell];
      for (const MaterialState &material : laid.material)
        motion.mass += material.mass[cell];
      motion.mean_u  = velocity;
      motion.kinetic = kinetic_per_gram * motion.mass;
      for (int d = 0; d < 2; ++d)
        motion.mean_x[d] = mesh.lower[d][cell] + 0.5 * mesh.size[cell];
    }

    SpreadReport
    spread()
    {
      return spread_excess(MPI_COMM_SELF, mesh, Halo<2>(MPI_COMM_SELF, mesh, {}), state, closed, laid);
    }

    double
    solid(const std::vector<MaterialState> &materials, Index cell) const
    {
      double sum = 0;
      for (const MaterialState &m : materials)
        sum += (1. - m.void_fraction[cell]) * m.volume[cell];
      return sum;
    }

    double
    fill(Index cell) const
    {
      return (solid(state.material, cell) + solid(laid.material, cell)) / state.volume[cell];
    }

    struct Sums
    {
      double    mass = 0, motion_mass = 0, solid = 0, internal = 0, kinetic = 0, strain = 0;
      Vector<2> momentum{};
    };
    Sums
    sums() const
    {
      Sums result;
      for (Index c = 0; c < mesh.n_cells; ++c)
        {
          for (const MaterialState &m : laid.material)
            {
              result.mass += m.mass[c];
              result.internal += m.mass[c] * m.energy[c];
              result.strain += m.mass[c] * m.fields[0].value[c];
            }
          const Motion &motion = laid.motion[c];
          result.solid += solid(laid.material, c);
          result.motion_mass += motion.mass;
          result.kinetic += motion.kinetic;
          for (int d = 0; d < 2; ++d)
            {
              result.momentum[d] += motion.mass * motion.mean_u[d];
              result.kinetic += 0.5 * motion.mass * motion.mean_u[d] * motion.mean_u[d];
            }
        }
      return result;
    }
  };

  Index
  cell_at(const FlatMesh<2> &mesh, double x, double y)
  {
    for (Index c = 0; c < mesh.n_cells; ++c)
      if (x > mesh.lower[0][c] && x < mesh.lower[0][c] + mesh.size[c] && y > mesh.lower[1][c] &&
          y < mesh.lower[1][c] + mesh.size[c])
        return c;
    return none;
  }
} // namespace

TEST(SpreadExcess, RandomOverfullStatesFitAfterwardsAndKeepEverything)
{
  figure::Largest change("spreading of overlapping solid: mass, momentum, energies, relative change", "<= 1e-13");
  for (const Symmetry symmetry : {Symmetry::planar, Symmetry::axisymmetric})
    for (unsigned seed = 1; seed <= 8; ++seed)
      {
        const auto grid = lattice(symmetry, 8, 1);
        Pile       pile(grid, seed % 2 ? hanging_keys(grid) : uniform_keys(grid, 1));
        Random     random(seed);
        double     solid = 0, room = 0;
        for (Index c = 0; c < pile.mesh.n_cells; ++c)
          {
            room += pile.state.volume[c];
            // one spot three times full, scattered pieces around
            const double x = pile.mesh.lower[0][c] - 0.3, y = pile.mesh.lower[1][c];
            const double fill = x * x + y * y < 0.02 ? random(1., 3.) : random(0., 1.) < 0.2 ? random(0., 1.5) : 0.;
            if (fill > 0)
              pile.put(c, fill, random(0., 0.3), {{random(-0.1, 0.1), random(0.4, 0.6)}}, random(0., 0.01));
            solid += pile.solid(pile.laid.material, c);
          }
        ASSERT_LT(solid, 0.9 * room);
        const auto before = pile.sums();
        const auto report = pile.spread();
        const auto after  = pile.sums();
        EXPECT_GT(report.moved.number, 0.);
        EXPECT_GT(report.moved.size, 0.);
        EXPECT_GT(report.depth, 1.5);
        for (Index c = 0; c < pile.mesh.n_cells; ++c)
          {
            EXPECT_LE(pile.fill(c), 1. + 1.0001 * excess_tolerance);
            for (int m = 0; m < 2; ++m)
              if (pile.laid.material[m].volume[c] > 0)
                {
                  // nothing has been squeezed or heated
                  const MaterialState &material = pile.laid.material[m];
                  EXPECT_NEAR(material.density[c] / (1. - material.void_fraction[c]), m ? 7.9 : 2.75, 1e-12);
                  EXPECT_NEAR(material.energy[c], 0.01 * (1 + m), 1e-15);
                }
          }
        const auto same = [&](double a, double b, double scale) {
          change((a - b) / scale);
          EXPECT_NEAR(a, b, 1e-13 * scale);
        };
        same(after.mass, before.mass, before.mass);
        same(after.motion_mass, before.mass, before.mass);
        same(after.solid, before.solid, before.solid);
        same(after.internal, before.internal, before.internal);
        same(after.strain, before.strain, before.strain);
        same(after.kinetic, before.kinetic, before.kinetic);
        for (int d = 0; d < 2; ++d)
          same(after.momentum[d], before.momentum[d], before.momentum[1]);
      }
}

TEST(SpreadExcess, WhatFitsStaysAsItIs)
{
  const auto grid = lattice(Symmetry::planar, 4, 0);
  Pile       pile(grid, uniform_keys(grid, 0));
  pile.put(5, 1.4, 0.5, {{0., 1.}}, 0.);
  pile.put(6, 1., 0., {{0., 1.}}, 0.);
  const auto report = pile.spread();
  EXPECT_EQ(report.moved.number, 0.);
  EXPECT_EQ(report.rounds, 0);
  EXPECT_EQ(pile.laid.material[0].volume[5], 0.7 * pile.state.volume[5]);
}

TEST(SpreadExcess, APlateThatIsThereStaysAndThrowsBackWhatWasLaidIntoIt)
{
  const auto grid = lattice(Symmetry::planar, 10, 0);
  Pile       pile(grid, uniform_keys(grid, 0));
  // a plate three cells thick; debris over two cells in front of it and one of its own
  for (Index c = 0; c < pile.mesh.n_cells; ++c)
    {
      const double y = pile.mesh.lower[1][c] + 0.3 + 0.05; // rows at 0.05, 0.15 ...
      if (y > 0.4 && y < 0.7)
        set_material(pile.state.material[1], c, pile.state.volume[c], 7.9, 0.001, 0.);
      if (y > 0.2 && y < 0.5 && pile.mesh.lower[0][c] > 0.35 && pile.mesh.lower[0][c] < 0.65)
        pile.put(c, 1., 0., {{0., 0.5}}, 0.);
    }
  EXPECT_EQ(pile.spread().moved.number, 3.);
  for (Index c = 0; c < pile.mesh.n_cells; ++c)
    {
      const double y = pile.mesh.lower[1][c] + 0.3 + 0.05;
      if (y > 0.4)
        {
          EXPECT_LE(pile.laid.motion[c].mass, 1.1e-6 * 7.9 * pile.state.volume[c]) << "in or behind the plate, " << y;
        }
      EXPECT_LE(pile.fill(c), 1. + 1.0001e-6);
    }
}

TEST(SpreadExcess, ClosedCellsTakeNothing)
{
  const auto grid = lattice(Symmetry::planar, 7, 0);
  Pile       pile(grid, uniform_keys(grid, 0));
  pile.closed.assign(pile.mesh.n_cells, 0);
  for (Index c = 0; c < pile.mesh.n_cells; ++c)
    pile.closed[c] = pile.mesh.lower[0][c] < 0.25;
  pile.put(cell_at(pile.mesh, 0.35, 0.05), 4., 0., {{0., 0.5}}, 0.);
  EXPECT_EQ(pile.spread().moved.number, 1.);
  for (Index c = 0; c < pile.mesh.n_cells; ++c)
    if (pile.closed[c])
      {
        EXPECT_EQ(pile.laid.motion[c].mass, 0.);
      }
}

TEST(SpreadExcess, WhatFindsNoRoomIsRefusedWithTheNumbers)
{
  const auto grid = lattice(Symmetry::planar, 2, 0);
  Pile       pile(grid, uniform_keys(grid, 0));
  pile.put(0, 4.5, 0., {{0., 0.5}}, 0.);
  try
    {
      pile.spread();
      FAIL();
    }
  catch (const NoRoomError &error)
    {
      EXPECT_NE(std::string(error.what()).find("cm^3 of solid"), std::string::npos) << error.what();
    }
}
