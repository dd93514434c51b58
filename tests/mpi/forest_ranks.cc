// SPDX-License-Identifier: LGPL-2.1-or-later
// Every test does the same work twice: on all ranks together, and on each rank alone; and compares bits.
#include <whipple/mesh/forest.h>
#include <whipple/mesh/key_index.h>
#include <whipple/mesh/refinement_map.h>

#include <gtest/gtest.h>

#include <algorithm>
#include <cmath>
#include <limits>

namespace
{
  using namespace whipple;

  // two root cells only: with three ranks and more some own nothing at first
  const Lattice<2> lattice{Symmetry::axisymmetric, {{0., -1.}}, 0.01, {{2, 1}}, 7};

  constexpr int n_rounds = 18;

  /// Reproducible noise from a key.
  std::uint64_t
  noise(CellKey key, std::uint64_t salt)
  {
    std::uint64_t h = (key + salt * 0x9e3779b97f4a7c15u) * 0xbf58476d1ce4e5b9u;
    h               = (h ^ (h >> 29)) * 0x94d049bb133111ebu;
    return h ^ (h >> 32);
  }

  /// Packets: volume in finest cells (a dyadic number), a value with an arbitrary fraction, then padding of a
  /// length that differs from leaf to leaf.
  CellPacket
  make_packet(double volume, double value, CellKey leaf)
  {
    CellPacket packet{volume, value};
    packet.resize(2 + noise(leaf, 1) % 7, value);
    return packet;
  }

  PacketRemap<2>
  remap()
  {
    PacketRemap<2> result;
    result.split = [](CellKey parent, const CellPacket &packet) {
      PacketRemap<2>::Children children;
      for (int k = 0; k < 4; ++k)
        children[k] = make_packet(packet[0] / 4., packet[1] * (0.1 + 0.3 * k) / 3., parent + k);
      return children;
    };
    result.merge = [](CellKey parent, const PacketRemap<2>::Children &children) {
      double volume = 0, value = 0;
      for (const CellPacket &child : children)
        if (!child.empty())
          {
            volume += child[0];
            value += child[1];
          }
      return make_packet(volume, value, parent);
    };
    return result;
  }

  unsigned int
  work(const CellPacket &packet)
  {
    return packet.empty() ? 1 : 20;
  }

  /// A forest with its packets on some ranks.
  struct Scenario
  {
    Forest<2>               forest;
    std::vector<CellPacket> packets;
    RefinementMap<2>        map;

    explicit Scenario(MPI_Comm communicator)
      : forest(communicator, lattice)
      , map(lattice)
    {
      for (const CellKey leaf : forest.leaves())
        packets.push_back(make_packet(std::pow(4., 7), 1. / 3., leaf));
    }

    /// A ring that moves and shrinks, with holes and specks that come and go; each rank asks for its share.
    bool
    adapt(int round)
    {
      int rank, ranks;
      MPI_Comm_rank(forest.communicator(), &rank);
      MPI_Comm_size(forest.communicator(), &ranks);
      map.clear();
      for (int i = rank; i < 200; i += ranks)
        {
          if (noise(i, round) % 8 == 0)
            continue;
          const double    angle = 2. * M_PI * i / 200., radius = 0.5 - 0.02 * round;
          const Vector<2> at{{0.8 + 0.05 * round + radius * std::cos(angle), -0.3 + radius * std::sin(angle)}};
          map.request(noise(i, 99 + round) % 3 == 0 ? 7 : 6, at, at, 1);
        }
      map.synchronise(forest.communicator());
      std::vector<std::uint8_t> target;
      for (const CellKey leaf : forest.leaves())
        target.push_back(noise(leaf, round) % 97 == 0 ? noise(leaf, 5) % 8 : map.target_level(leaf));
      const bool changed = forest.adapt(target, packets, remap(), work);
      if (round == 6) // from now on half of the leaves hold nothing
        for (std::size_t i = 0; i < packets.size(); ++i)
          if (key_point<2>(forest.leaves()[i])[0] < 100)
            packets[i].clear();
      return changed;
    }

    std::vector<std::uint8_t>
    active() const
    {
      std::vector<std::uint8_t> result;
      for (const CellPacket &packet : packets)
        result.push_back(!packet.empty());
      return result;
    }
  };

  int
  first_leaf(const Scenario &run)
  {
    const int n     = static_cast<int>(run.forest.leaves().size());
    int       first = 0;
    MPI_Exscan(&n, &first, 1, MPI_INT, MPI_SUM, run.forest.communicator());
    int rank;
    MPI_Comm_rank(run.forest.communicator(), &rank);
    return rank == 0 ? 0 : first; // Exscan leaves rank 0's undefined
  }

  /// Leaves and packets of this rank are those of the forest on one rank.
  void
  expect_same(const Scenario &all, const Scenario &alone, int round)
  {
    EXPECT_TRUE(std::ranges::equal(all.forest.all_leaves(), alone.forest.all_leaves())) << "round " << round;
    const auto        mine  = all.forest.leaves();
    const std::size_t first = first_leaf(all);
    ASSERT_LE(first + mine.size(), alone.packets.size());
    ASSERT_EQ(all.packets.size(), mine.size());
    for (std::size_t i = 0; i < mine.size(); ++i)
      {
        EXPECT_EQ(mine[i], alone.forest.leaves()[first + i]);
        EXPECT_EQ(all.packets[i], alone.packets[first + i]) << "round " << round << ", leaf " << first + i;
      }
  }

  double
  total_volume(const Scenario &run)
  {
    double mine = 0, total;
    for (const CellPacket &packet : run.packets)
      mine += packet.empty() ? 0. : packet[0];
    MPI_Allreduce(&mine, &total, 1, MPI_DOUBLE, MPI_SUM, run.forest.communicator());
    return total;
  }

  TEST(ForestOnRanks, LeavesAndPacketsAreThoseOfOneRank)
  {
    Scenario all(MPI_COMM_WORLD), alone(MPI_COMM_SELF);
    double   volume    = total_volume(all);
    int      coarsened = 0;
    EXPECT_EQ(volume, 2. * std::pow(4., 7));
    for (int round = 0; round < n_rounds; ++round)
      {
        const std::size_t before = alone.forest.all_leaves().size();
        EXPECT_EQ(all.adapt(round), alone.adapt(round));
        coarsened += alone.forest.all_leaves().size() < before;
        expect_same(all, alone, round);
        if (round == 6)
          volume = total_volume(all);
        EXPECT_EQ(total_volume(all), volume) << "round " << round;
      }
    EXPECT_GT(coarsened, 2);
    EXPECT_GT(alone.forest.all_leaves().size(), 800u);

    all.forest.repartition(all.packets, [](const CellPacket &packet) { return packet.empty() ? 1u : 1000u; });
    expect_same(all, alone, n_rounds);

    int ranks;
    MPI_Comm_size(MPI_COMM_WORLD, &ranks);
    const auto held  = [](const Scenario &run) { return std::ranges::count(run.active(), 1); };
    const auto share = static_cast<double>(held(alone)) / ranks;
    EXPECT_NEAR(static_cast<double>(held(all)), share, 0.1 * share + 8.) << "material must be spread evenly";
  }

  TEST(ForestOnRanks, EverythingCoarsensBackToTheRoots)
  {
    Scenario all(MPI_COMM_WORLD);
    for (int round = 0; round < 8; ++round)
      all.adapt(round);
    const double volume = total_volume(all);
    all.forest.adapt_until([](CellKey) { return std::uint8_t{0}; }, all.packets, remap(), work);
    EXPECT_EQ(all.forest.all_leaves().size(), 2u);
    EXPECT_EQ(total_volume(all), volume);
  }

  /// Steps from cell to touching cell between any of `from` and each cell, by exhaustion.
  std::vector<int>
  layers(const std::vector<CellKey> &cells, const std::vector<std::uint8_t> &from, int width)
  {
    const auto touch = [](CellKey a, CellKey b) {
      const LatticePoint<2> p = key_point<2>(a), q = key_point<2>(b);
      const int             e = lattice.extent(key_level(a)), f = lattice.extent(key_level(b));
      return p[0] <= q[0] + f && q[0] <= p[0] + e && p[1] <= q[1] + f && q[1] <= p[1] + e;
    };
    std::vector<int> layer(cells.size(), -1);
    for (std::size_t i = 0; i < cells.size(); ++i)
      layer[i] = from[i] ? 0 : -1;
    for (int step = 0; step < width; ++step)
      for (std::size_t i = 0; i < cells.size(); ++i)
        for (std::size_t j = 0; layer[i] == step && j < cells.size(); ++j)
          if (layer[j] < 0 && touch(cells[i], cells[j]))
            layer[j] = step + 1;
    return layer;
  }

  double
  wave(double x, double y, int k)
  {
    return std::sin(3. * x + k) * std::cos(5. * y - k);
  }

  /// Owned entries of each array hold the wave; after the exchange halo entries must do so too.
  void
  expect_exchange(const FlatPartition<2> &part)
  {
    const FlatMesh<2>  &mesh    = part.mesh;
    const double        invalid = std::numeric_limits<double>::quiet_NaN();
    std::vector<double> cell[2], node[2], corner(4 * mesh.n_cells, invalid);
    const auto          at_cell = [&](Index c, int k) { return wave(mesh.lower[0][c], mesh.lower[1][c], k); };
    const auto          at_node = [&](Index n, int k) { return wave(mesh.node_point[0][n], mesh.node_point[1][n], k); };
    for (int a = 0; a < 2; ++a)
      {
        cell[a].assign(mesh.n_cells, invalid);
        node[a].assign(mesh.n_nodes, invalid);
        for (Index c = 0; c < mesh.n_owned; ++c)
          {
            cell[a][c] = at_cell(c, a);
            for (int k = 0; k < 4; ++k)
              {
                corner[4 * c + k]                  = at_cell(c, 10 + k);
                node[a][mesh.cell_node[4 * c + k]] = at_node(mesh.cell_node[4 * c + k], a);
              }
          }
      }
    std::vector<double> *const cells[]{&cell[0], &cell[1]}, *const nodes[]{&node[0], &node[1]},
                                                                *const corners[]{&corner};
    part.halo.exchange(cells, nodes);
    part.halo.exchange_corners(corners);
    for (int a = 0; a < 2; ++a)
      {
        for (Index c = 0; c < mesh.n_cells; ++c)
          EXPECT_EQ(cell[a][c], at_cell(c, a));
        for (Index n = 0; n < mesh.n_nodes; ++n)
          EXPECT_EQ(node[a][n], at_node(n, a));
      }
    for (Index c = 0; c < mesh.n_cells; ++c)
      for (int k = 0; k < 4; ++k)
        EXPECT_EQ(corner[4 * c + k], at_cell(c, 10 + k));
  }

  /// The cells around each node of an owned cell, in the order sums take, and whether the node hangs.
  void
  expect_same_nodes(const FlatMesh<2> &mesh, const FlatMesh<2> &whole, Index first)
  {
    const auto around = [](const FlatMesh<2> &m, Index n) {
      std::vector<std::pair<CellKey, int>> result;
      for (Index i = m.node_corner_begin[n]; i < m.node_corner_begin[n + 1]; ++i)
        result.push_back({m.key[m.node_corner[i] / 4], m.node_corner[i] % 4});
      return result;
    };
    const auto hangs = [](const FlatMesh<2> &m) {
      std::vector<std::uint8_t> result(m.n_nodes, 0);
      for (const Index n : m.hanging)
        result[n] = 1;
      return result;
    };
    const std::vector<std::uint8_t> hanging = hangs(mesh), hanging_whole = hangs(whole);
    for (Index c = 0; c < mesh.n_owned; ++c)
      for (int k = 0; k < 4; ++k)
        {
          const Index n = mesh.cell_node[4 * c + k], m = whole.cell_node[4 * (first + c) + k];
          EXPECT_EQ(around(mesh, n), around(whole, m));
          EXPECT_EQ(hanging[n], hanging_whole[m]);
          EXPECT_EQ(mesh.node_side[n], whole.node_side[m]);
        }
  }

  TEST(ForestOnRanks, HaloIsCompleteAndExchanged)
  {
    Scenario all(MPI_COMM_WORLD), alone(MPI_COMM_SELF);
    for (int round = 0; round < n_rounds; ++round)
      {
        all.adapt(round);
        alone.adapt(round);
        if (round < 3 || round > 8)
          for (const Cohesion cohesion : {Cohesion::bonded, Cohesion::fragments})
            {
              const int          width = round % 4;
              const auto         part  = all.forest.flatten(all.active(), width, cohesion);
              const auto         whole = alone.forest.flatten(alone.active(), 0, cohesion);
              const FlatMesh<2> &mesh  = part->mesh;
              expect_exchange(*part);

              // where this rank's cells begin among all active ones
              const auto  begin = alone.active();
              const Index first = static_cast<Index>(std::count(begin.begin(), begin.begin() + first_leaf(all), 1));
              std::vector<std::uint8_t> owned(whole->mesh.n_cells, 0);
              std::fill_n(owned.begin() + first, mesh.n_owned, 1);
              const std::vector<int> layer = layers(whole->mesh.key, owned, width);
              const KeyIndex         present{std::span<const CellKey>(mesh.key)};
              for (Index c = 0; c < whole->mesh.n_cells; ++c)
                {
                  const Index here = present.find(whole->mesh.key[c]);
                  EXPECT_EQ(here == none ? -1 : int(mesh.layer[here]), layer[c]);
                }
              EXPECT_TRUE(std::is_sorted(mesh.key.begin() + mesh.n_owned, mesh.key.end()));
              if (width > 0)
                expect_same_nodes(mesh, whole->mesh, first);
            }
      }
  }
} // namespace
