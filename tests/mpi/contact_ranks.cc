// SPDX-License-Identifier: LGPL-2.1-or-later
// Contacts between elements are found and joined on all ranks together, and on each rank alone; bits are compared.
#include <whipple/ledger/totals.h>
#include <whipple/mesh/gather.h>
#include <whipple/mesh/key_index.h>
#include <whipple/run/contact.h>
#include <whipple/run/contact_search.h>
#include <whipple/state/packet_layout.h>
#include <whipple/state/velocity_gather.h>

#include <gtest/gtest.h>

#include <cmath>
#include <set>

namespace
{
  using namespace whipple;

  constexpr double edge = 0.05;

  Lattice<2>
  lattice(Symmetry symmetry)
  {
    return {symmetry, {{0., -1.}}, edge, {{12, 40}}, 0};
  }

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

  /// Two slabs of elements, three rows each, one behind the other, moved into one another.
  struct Slabs
  {
    Domain<2> domain;

    /// @param overlap  how far the rear one has run into the front one, cm
    Slabs(MPI_Comm communicator, Symmetry symmetry, Cohesion cohesion, double overlap, double phi, double scatter)
      : domain{Forest<2>(communicator, lattice(symmetry)), nullptr, {}}
    {
      std::vector<std::uint8_t> active;
      for (const CellKey key : domain.forest.leaves())
        active.push_back(row(key) >= 10 && row(key) < 16 ? 1 : 0);
      // bodies do not hold together across the gap: the first three rows broken for themselves would be fragments, so
      // a row between them is left out
      for (std::size_t i = 0; i < active.size(); ++i)
        active[i] = active[i] && row(domain.forest.leaves()[i]) != 13;
      domain.view = domain.forest.flatten(active, 3, cohesion);

      const FlatMesh<2> &mesh = domain.view->mesh;
      State<2>           like;
      like.material.resize(1);
      like.material[0].void_fraction = {0.};
      State<2> &state                = domain.state;
      state                          = empty_state_like<2>(like, mesh);
      CornerVelocities<2> corners(mesh.n_cells);
      for (Index c = 0; c < mesh.n_cells; ++c)
        {
          MaterialState &m   = state.material[0];
          m.volume[c]        = state.volume[c];
          m.void_fraction[c] = phi;
          m.density[c]       = (2. + noise(mesh.key[c], 1)) * (1. - phi);
          m.mass[c]          = m.density[c] * m.volume[c];
          m.energy[c]        = 0.001;
          for (int k = 0; k < 4; ++k)
            {
              corners.velocity[0][4 * c + k] = scatter * noise(mesh.key[c], 5 + k);
              corners.velocity[1][4 * c + k] = is_rear(c) ? 0.5 : 0.3;
            }
        }
      gather_velocities(mesh, axis_and_open_sides(), corners, KineticLoss::drop, state);
      // rear slab: rows 10 to 12; front: 14 and 15, so they touch when moved by one row
      for (Index n = 0; n < mesh.n_nodes; ++n)
        if (mesh.node_point[1][n] < -1. + 13.5 * edge)
          state.position[1][n] += edge + overlap;
      domain.view->halo.exchange(
          {}, std::vector<std::vector<double> *>{&state.velocity[0], &state.velocity[1], &state.node_mass});
    }

    int
    row(CellKey key) const
    {
      return key_point<2>(key)[1];
    }
    bool
    is_rear(Index c) const
    {
      return row(domain.view->mesh.key[c]) < 13;
    }

    ContactLook<2>
    join()
    {
      return join_contacts(axis_and_open_sides(), KineticLoss::heat, domain);
    }
    ConservedTotals<2>
    sums() const
    {
      return totals(domain.view->mesh, domain.state, domain.communicator());
    }
  };

  void
  expect_same_cells(const Domain<2> &all, const Domain<2> &alone)
  {
    const FlatMesh<2> &mesh = all.view->mesh, &whole = alone.view->mesh;
    const KeyIndex     where{std::span<const CellKey>(whole.key)};
    for (Index c = 0; c < mesh.n_owned; ++c)
      {
        const Index there = where.find(mesh.key[c]);
        EXPECT_EQ(all.state.material[0].energy[c], alone.state.material[0].energy[there]);
        for (int k = 0; k < 4; ++k)
          for (int d = 0; d < 2; ++d)
            EXPECT_EQ(all.state.velocity[d][mesh.cell_node[4 * c + k]],
                      alone.state.velocity[d][whole.cell_node[4 * there + k]]);
      }
  }

  TEST(Contact, TwoSlabsThatTouchOrAreThinAreNotInContact)
  {
    for (const Cohesion cohesion : {Cohesion::fragments, Cohesion::bonded})
      {
        EXPECT_EQ(Slabs(MPI_COMM_WORLD, Symmetry::planar, cohesion, 0., 0., 0.).join().joined, 0);
        EXPECT_EQ(Slabs(MPI_COMM_WORLD, Symmetry::planar, cohesion, 0.05 * edge, 0., 0.).join().joined, 0);
        EXPECT_EQ(Slabs(MPI_COMM_WORLD, Symmetry::planar, cohesion, 0.4 * edge, 0.6, 0.).join().joined, 0);
      }
  }

  TEST(Contact, OverlappingSlabsAreJoinedAndKeepWhatIsConserved)
  {
    for (const Symmetry symmetry : {Symmetry::planar, Symmetry::axisymmetric})
      for (const Cohesion cohesion : {Cohesion::fragments, Cohesion::bonded})
        for (const double scatter : {0., 0.01})
          {
            Slabs      all(MPI_COMM_WORLD, symmetry, cohesion, 0.2 * edge, 0., scatter);
            Slabs      alone(MPI_COMM_SELF, symmetry, cohesion, 0.2 * edge, 0., scatter);
            const auto before = all.sums();
            const auto report = all.join();
            const auto after  = all.sums();
            EXPECT_EQ(report.joined, alone.join().joined);
            EXPECT_EQ(report.joined, 24); // the two rows that meet
            EXPECT_EQ(after.mass, before.mass);
            EXPECT_NEAR(after.momentum[1], before.momentum[1], 1e-14 * before.momentum[1]);
            EXPECT_NEAR(after.total_energy(), before.total_energy(), 1e-14 * before.total_energy());
            EXPECT_NEAR(before.kinetic_energy - after.kinetic_energy, report.bookings.of("contact").converted.value(),
                        1e-14 * before.kinetic_energy);
            EXPECT_GT(report.bookings.of("contact").converted.value(), 0.);
            expect_same_cells(all.domain, alone.domain);
            if (cohesion == Cohesion::fragments)
              {
                // each column moves as one now, between the two velocities, and a second look changes nothing
                const auto &v    = all.domain.state.velocity[1];
                const auto &mesh = all.domain.view->mesh;
                for (Index c = 0; c < mesh.n_owned; ++c)
                  if (all.row(mesh.key[c]) == 12 || all.row(mesh.key[c]) == 14)
                    for (int k = 0; k < 4; ++k)
                      {
                        EXPECT_EQ(v[mesh.cell_node[4 * c + k]], v[mesh.cell_node[4 * c]]);
                        EXPECT_LT(v[mesh.cell_node[4 * c + k]], 0.45);
                        EXPECT_GT(v[mesh.cell_node[4 * c + k]], 0.35);
                      }
                EXPECT_EQ(all.join().joined, 0);
              }
            else
              EXPECT_LT(all.sums().kinetic_energy, before.kinetic_energy);
          }
  }

  TEST(Contact, ElementsInOnePlaceAreDeep)
  {
    Slabs      slabs(MPI_COMM_WORLD, Symmetry::planar, Cohesion::fragments, 2. * edge, 0., 0.);
    const auto report = slabs.join();
    EXPECT_EQ(report.deep, 48); // two rows on two rows
    EXPECT_TRUE(overlap_is_deep(report));
    EXPECT_FALSE(
        overlap_is_deep(Slabs(MPI_COMM_WORLD, Symmetry::planar, Cohesion::fragments, 0.2 * edge, 0., 0.).join()));
  }

  TEST(Contact, AChainOfPiecesIsOneClusterAndCrossingStreamsJoin)
  {
    using namespace contact;
    const auto piece = [](CellKey key, double x, double y, const Vector<2> &u) {
      Piece p;
      p.key = key;
      for (int k = 0; k < 4; ++k)
        {
          p.x[0][k] = x + (k & 1 ? 0.5 : -0.5);
          p.x[1][k] = y + (k & 2 ? 0.5 : -0.5);
        }
      p.middle   = {{x, y}};
      p.velocity = u;
      p.size = p.solid = p.mass = 1.;
      return p;
    };
    // each runs into the next
    std::vector<Piece> chain;
    for (int i = 0; i < 50; ++i)
      chain.push_back(piece(i, 0.7 * i, 0., {{1. - 0.01 * i, 0.}}));
    int rank;
    MPI_Comm_rank(MPI_COMM_WORLD, &rank);
    // on any number of ranks: here all pieces come from rank 0
    const auto                            mine  = rank == 0 ? std::span<const Piece>(chain) : std::span<const Piece>();
    const auto                            found = search(MPI_COMM_WORLD, mine);
    std::set<std::pair<CellKey, CellKey>> pairs;
    for (const Pair &pair : gather_all<Pair>(MPI_COMM_WORLD, found.pairs).entry)
      {
        EXPECT_EQ(pair.approaching, 1);
        pairs.insert({pair.a.key, pair.b.key});
      }
    EXPECT_EQ(pairs.size(), 2u * 49);

    // two streams that cross at a right angle, and one that leaves
    const std::vector<Piece> crossing{piece(1, 0., 0., {{1., 0.}}), piece(2, 0.3, 0.3, {{0., -1.}}),
                                      piece(3, 10., 0., {{-1., 0.}}), piece(4, 10.3, 0., {{1., 0.}})};
    const auto               alone = search(MPI_COMM_SELF, crossing);
    ASSERT_FALSE(alone.pairs.empty());
    for (const Pair &pair : alone.pairs)
      EXPECT_LE(std::max(pair.a.key, pair.b.key), 2u);
  }

  TEST(Contact, ALookIsDueWhenThingsCanHaveMet)
  {
    ContactSchedule schedule;
    ContactLook<2>  quiet, close;
    quiet.time_to_next = HUGE_VAL;
    close.time_to_next = 0.35;
    EXPECT_TRUE(schedule.due(0, 0.));
    schedule.looked(0, 0., 0.1, quiet);
    EXPECT_FALSE(schedule.due(19, 1.9));
    EXPECT_TRUE(schedule.due(20, 2.));
    schedule.looked(20, 2., 0.1, close);
    EXPECT_FALSE(schedule.due(22, 2.2));
    EXPECT_TRUE(schedule.due(23, 2.3));
    EXPECT_TRUE(schedule.due(21, 2.4)) << "one long step";
    schedule.looked(23, 2.3, 1., close);
    EXPECT_TRUE(schedule.due(24, 3.3));
  }
} // namespace
