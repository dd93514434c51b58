// SPDX-License-Identifier: LGPL-2.1-or-later
// Bonds break twice on all ranks together, and on each rank alone; bits are compared.
#include <whipple/ledger/totals.h>
#include <whipple/mesh/key_index.h>
#include <whipple/run/bond_breaking.h>
#include <whipple/state/packet_layout.h>
#include <whipple/state/velocity_gather.h>

#include <gtest/gtest.h>

#include <cmath>

namespace
{
  using namespace whipple;

  const Lattice<2> lattice{Symmetry::axisymmetric, {{0., -1.}}, 0.05, {{5, 6}}, 1};

  /// Reproducible noise in [0, 1) from a key.
  double
  noise(CellKey key, std::uint64_t salt)
  {
    std::uint64_t h = (key + salt * 0x9e3779b97f4a7c15u) * 0xbf58476d1ce4e5b9u;
    h               = (h ^ (h >> 29)) * 0x94d049bb133111ebu;
    return static_cast<double>((h ^ (h >> 32)) >> 11) * 0x1p-53;
  }

  Boundaries<2>
  axis_and_open_sides()
  {
    Boundaries<2> boundaries;
    boundaries[0].kind = BoundaryKind::reflecting;
    return boundaries;
  }

  /// A bonded body of porous material with hanging nodes, on its way.
  struct Body
  {
    Domain<2> domain;

    explicit Body(MPI_Comm communicator)
      : domain{Forest<2>(communicator, lattice), nullptr, {}}
    {
      fill();
    }

    /// Porosity of a cell; the second time more of it.
    void
    open_voids(int time)
    {
      for (Index c = 0; c < domain.view->mesh.n_cells; ++c)
        domain.state.material[0].void_fraction[c] = 0.2 * noise(domain.view->mesh.key[c], time);
    }

    void
    fill()
    {
      std::vector<CellPacket> packets(domain.forest.leaves().size());
      const auto              level = [](CellKey leaf) {
        return static_cast<std::uint8_t>(key_level(leaf) == 1 || noise(leaf, 7) < 0.4);
      };
      domain.forest.adapt_until(level, packets, PacketRemap<2>{});
      domain.view =
          domain.forest.flatten(std::vector<std::uint8_t>(domain.forest.leaves().size(), 1), 3, Cohesion::bonded);

      const FlatMesh<2> &mesh = domain.view->mesh;
      State<2>           like;
      like.material.resize(1);
      like.material[0].void_fraction = {0.};
      State<2> &state                = domain.state;
      state                          = empty_state_like<2>(like, mesh);
      CornerVelocities<2> corners(mesh.n_cells);
      for (Index c = 0; c < mesh.n_cells; ++c)
        {
          MaterialState &material = state.material[0];
          material.volume[c]      = state.volume[c];
          material.density[c]     = 2. + noise(mesh.key[c], 1);
          material.mass[c]        = material.density[c] * material.volume[c];
          material.energy[c]      = 0.001 * noise(mesh.key[c], 2);
          for (int k = 0; k < 4; ++k)
            for (int d = 0; d < 2; ++d)
              corners.velocity[d][4 * c + k] = 0.5 * d + 0.1 * noise(mesh.key[c], 10 + 2 * k + d);
        }
      gather_velocities(mesh, axis_and_open_sides(), corners, KineticLoss::drop, state);
      for (Index n = 0; n < mesh.n_nodes; ++n)
        state.position[1][n] += 0.01 * std::sin(30. * mesh.node_point[0][n]);
      domain.view->halo.exchange(
          {}, std::vector<std::vector<double> *>{&state.velocity[0], &state.velocity[1], &state.node_mass});
    }

    struct Look
    {
      long       broken;
      Booking<2> booking;
    };
    Look
    look()
    {
      Bookings<2> bookings;
      const long  broken =
          break_bonds({.void_fraction = 0.15, .shape = 0.}, axis_and_open_sides(), KineticLoss::heat, domain, bookings);
      return {broken, bookings.of("broken bonds")};
    }
  };

  /// Owned cells of `all` are those of `alone`, bit for bit.
  void
  expect_same_cells(const Domain<2> &all, const Domain<2> &alone)
  {
    const FlatMesh<2> &mesh = all.view->mesh, &whole = alone.view->mesh;
    const KeyIndex     where{std::span<const CellKey>(whole.key)};
    for (Index c = 0; c < mesh.n_owned; ++c)
      {
        const Index there = where.find(mesh.key[c]);
        EXPECT_EQ(mesh.intact[c], whole.intact[there]);
        EXPECT_EQ(all.state.material[0].energy[c], alone.state.material[0].energy[there]);
        for (int k = 0; k < 4; ++k)
          {
            const Index n = mesh.cell_node[4 * c + k], m = whole.cell_node[4 * there + k];
            EXPECT_EQ(all.state.node_mass[n], alone.state.node_mass[m]);
            EXPECT_EQ(mesh.node_corner_begin[n + 1] - mesh.node_corner_begin[n],
                      whole.node_corner_begin[m + 1] - whole.node_corner_begin[m]);
            for (int d = 0; d < 2; ++d)
              {
                EXPECT_EQ(all.state.position[d][n], alone.state.position[d][m]);
                EXPECT_EQ(all.state.velocity[d][n], alone.state.velocity[d][m]);
              }
          }
      }
  }

  TEST(BondBreakingOnRanks, KeepsWhatIsConservedAndTheSameBits)
  {
    Body               all(MPI_COMM_WORLD), alone(MPI_COMM_SELF);
    const MPI_Comm     world = MPI_COMM_WORLD;
    const FlatMesh<2> *first = &all.domain.view->mesh;
    EXPECT_EQ(all.look().broken, 0); // no voids yet
    EXPECT_EQ(&all.domain.view->mesh, first);

    long broken = 0;
    for (const int time : {3, 4})
      {
        all.open_voids(time);
        alone.open_voids(time);
        const auto before = totals(all.domain.view->mesh, all.domain.state, world);
        const auto report = all.look();
        const auto after  = totals(all.domain.view->mesh, all.domain.state, world);
        EXPECT_EQ(report.broken, alone.look().broken);
        EXPECT_GT(report.broken, 0);
        broken += report.broken;
        EXPECT_EQ(after.mass, before.mass);
        EXPECT_NEAR(after.momentum[1], before.momentum[1], 1e-14 * before.momentum[1]);
        EXPECT_NEAR(after.total_energy(), before.total_energy(), 1e-14 * before.total_energy());
        EXPECT_NEAR(before.kinetic_energy - after.kinetic_energy, report.booking.converted.value(),
                    1e-14 * before.kinetic_energy);
        EXPECT_GT(report.booking.converted.value(), 0.); // hanging nodes that came free
        expect_same_cells(all.domain, alone.domain);
        EXPECT_EQ(all.look().broken, 0);
      }
    double intact = 0, cells = 0;
    for (Index c = 0; c < alone.domain.view->mesh.n_owned; ++c)
      {
        intact += alone.domain.view->mesh.intact[c];
        ++cells;
      }
    EXPECT_EQ(intact + static_cast<double>(broken), cells); // what was broken stays so
    EXPECT_GT(intact, 0.);
  }
} // namespace
