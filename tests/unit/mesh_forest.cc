// SPDX-License-Identifier: LGPL-2.1-or-later
#include "reference_round.h"

#include <whipple/error.h>
#include <whipple/mesh/forest.h>
#include <whipple/mesh/key_arithmetic.h>

#include <gtest/gtest.h>

#include <random>

namespace
{
  using namespace whipple;

  const Lattice<2> lattice{Symmetry::axisymmetric, {}, 0.5, {{2, 3}}, 4};

  /// Packets {volume, number of merges and splits behind it}: volumes of squares, dyadic numbers, so sums are exact.
  PacketRemap<2>
  volume_remap()
  {
    PacketRemap<2> remap;
    remap.split = [](CellKey, const CellPacket &packet) {
      PacketRemap<2>::Children children;
      children.fill({packet[0] / 4., packet[1] + 1.});
      return children;
    };
    remap.merge = [](CellKey, const PacketRemap<2>::Children &children) {
      CellPacket sum(2, 0.);
      for (const CellPacket &child : children)
        {
          sum[0] += child[0];
          sum[1] = std::max(sum[1], child[1] + 1.);
        }
      return sum;
    };
    return remap;
  }

  double
  volume(CellKey leaf)
  {
    const double edge = lattice.extent(key_level(leaf));
    return edge * edge;
  }

  std::vector<CellKey>
  sorted(std::span<const CellKey> keys)
  {
    std::vector<CellKey> result(keys.begin(), keys.end());
    std::sort(result.begin(), result.end());
    return result;
  }

  TEST(Forest, StartsFromItsRoots)
  {
    const Forest<2> forest(MPI_COMM_SELF, lattice);
    EXPECT_EQ(sorted(forest.leaves()), (std::vector<CellKey>{make_key<2>(0, {{0, 0}}), make_key<2>(0, {{16, 0}}),
                                                             make_key<2>(0, {{0, 16}}), make_key<2>(0, {{16, 16}}),
                                                             make_key<2>(0, {{0, 32}}), make_key<2>(0, {{16, 32}})}));
  }

  TEST(Forest, RandomRoundsFollowTheReferenceAndKeepVolume)
  {
    std::mt19937            random(11);
    Forest<2>               forest(MPI_COMM_SELF, lattice);
    std::vector<CellPacket> packets;
    for (const CellKey leaf : forest.leaves())
      packets.push_back({volume(leaf), 0.});
    int coarsened = 0, refined = 0;
    for (int round = 0; round < 40; ++round)
      {
        // targets that agree over patches of 4 x 4 finest cells now and then, so that families do coarsen
        const int                    patch = 4 << (random() % 2);
        std::vector<int>             map(64 * 64);
        std::vector<std::uint8_t>    target;
        std::vector<reference::Leaf> leaves;
        for (int &level : map)
          level = static_cast<int>(random() % 6) - 1;
        for (const CellKey leaf : forest.leaves())
          {
            const LatticePoint<2> p = key_point<2>(leaf);
            target.push_back(static_cast<std::uint8_t>(std::max(map[p[1] / patch * 64 + p[0] / patch], 0)));
            leaves.push_back({key_level(leaf), p[0], p[1], target.back()});
          }
        const std::vector<CellKey> before   = sorted(forest.leaves());
        const std::vector<CellKey> expected = reference::round(lattice, leaves);
        const bool                 changed  = forest.adapt(target, packets, volume_remap());
        ASSERT_EQ(sorted(forest.leaves()), expected) << "round " << round;
        EXPECT_EQ(changed, before != expected);
        coarsened += expected.size() < before.size();
        refined += expected.size() > before.size();

        ASSERT_EQ(packets.size(), forest.leaves().size());
        double total = 0;
        for (std::size_t i = 0; i < packets.size(); ++i)
          {
            ASSERT_EQ(packets[i][0], volume(forest.leaves()[i]));
            total += packets[i][0];
          }
        EXPECT_EQ(total, 32. * 48.);
      }
    EXPECT_GT(coarsened, 3);
    EXPECT_GT(refined, 3);
  }

  TEST(Forest, AdaptUntilReachesItsTargetsAndComesBack)
  {
    Forest<2>               forest(MPI_COMM_SELF, lattice);
    std::vector<CellPacket> packets(forest.leaves().size());
    packets[2]        = {volume(forest.leaves()[2]), 0.};
    const auto centre = [](CellKey leaf) -> std::uint8_t {
      const LatticePoint<2> p = key_point<2>(leaf);
      const int             e = lattice.extent(key_level(leaf));
      return p[0] <= 16 && 16 <= p[0] + e && p[1] <= 20 && 20 <= p[1] + e ? 4 : 0;
    };
    EXPECT_EQ(forest.adapt_until(centre, packets, volume_remap()), 4);
    int finest = 0;
    for (const CellKey leaf : forest.leaves())
      finest += centre(leaf) == 4 && key_level(leaf) == 4;
    EXPECT_EQ(finest, 4);

    EXPECT_GT(forest.adapt_until([](CellKey) { return std::uint8_t{0}; }, packets, volume_remap()), 3);
    ASSERT_EQ(forest.leaves().size(), 6u);
    for (int i = 0; i < 6; ++i)
      EXPECT_EQ(packets[i].empty(), i != 2);
    EXPECT_EQ(packets[2][0], 256.);
  }

  TEST(Forest, IsRebuiltFromItsKeys)
  {
    // what a restart does: refine the roots towards a set of leaves that is balanced
    std::mt19937            random(5);
    Forest<2>               forest(MPI_COMM_SELF, lattice);
    std::vector<CellPacket> packets(forest.leaves().size());
    for (int round = 0; round < 6; ++round)
      {
        std::vector<std::uint8_t> target;
        for (const CellKey leaf : forest.leaves())
          target.push_back(random() % 4 == 0 ? 4 : key_level(leaf));
        forest.adapt(target, packets, volume_remap());
      }
    const std::vector<CellKey> saved(forest.leaves().begin(), forest.leaves().end());
    Forest<2>                  again(MPI_COMM_SELF, lattice);
    std::vector<CellPacket>    none_yet(again.leaves().size());
    again.adapt_until(
        [&](CellKey leaf) {
          std::uint8_t finest = 0;
          for (const CellKey key : saved)
            if (key_level(key) >= key_level(leaf) && ancestor_key(lattice, key, key_level(leaf)) == leaf)
              finest = std::max<std::uint8_t>(finest, key_level(key));
          return finest;
        },
        none_yet, volume_remap());
    EXPECT_TRUE(std::ranges::equal(again.leaves(), saved));
  }

  TEST(Forest, RefusesWhatDoesNotFit)
  {
    Forest<2>                       forest(MPI_COMM_SELF, lattice);
    std::vector<CellPacket>         packets(6);
    const std::vector<std::uint8_t> too_few(5, 0), too_fine(6, 5);
    EXPECT_THROW(forest.adapt(too_few, packets, {}), StateError);
    EXPECT_THROW(forest.adapt(too_fine, packets, {}), StateError);
    packets.pop_back();
    EXPECT_THROW(forest.adapt(std::vector<std::uint8_t>(6, 1), packets, {}), StateError);
    EXPECT_THROW(Forest<2>(MPI_COMM_SELF, {Symmetry::planar, {}, 1., {{1, 1}}, 20}), InputError);
  }
} // namespace
