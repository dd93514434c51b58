// SPDX-License-Identifier: LGPL-2.1-or-later
#include "reference_round.h"

#include <whipple/error.h>
#include <whipple/mesh/level_agreement.h>

#include <gtest/gtest.h>

#include <random>

namespace
{
  using namespace whipple;

  const Lattice<2> lattice{Symmetry::planar, {}, 1., {{3, 1}}, 4}; // 48 x 16 finest cells

  /// Roots 0 and 2, and the children of root 1 between them.
  const std::vector<CellKey> row{make_key<2>(0, {{0, 0}}),  make_key<2>(1, {{16, 0}}), make_key<2>(1, {{24, 0}}),
                                 make_key<2>(1, {{16, 8}}), make_key<2>(1, {{24, 8}}), make_key<2>(0, {{32, 0}})};

  std::vector<std::uint8_t>
  agree(std::vector<std::uint8_t> target)
  {
    return agree_levels<2>(lattice, row, target);
  }

  TEST(LevelAgreement, RefinementRaisesNeighbours)
  {
    // the lower left child goes to level 2: root 0 touches it and must follow, root 2 need not
    EXPECT_EQ(agree({0, 3, 1, 1, 1, 0}), (std::vector<std::uint8_t>{1, 2, 1, 1, 1, 0}));
  }

  TEST(LevelAgreement, RefinementNextToItCancelsNoCoarseningOfOthers)
  {
    EXPECT_EQ(agree({1, 0, 0, 0, 0, 0}), (std::vector<std::uint8_t>{1, 0, 0, 0, 0, 0}));
  }

  TEST(LevelAgreement, OneSiblingKeepsTheFamily)
  {
    EXPECT_EQ(agree({0, 0, 0, 1, 0, 0}), (std::vector<std::uint8_t>{0, 1, 1, 1, 1, 0}));
    EXPECT_EQ(agree({0, 0, 0, 0, 0, 0}), (std::vector<std::uint8_t>{0, 0, 0, 0, 0, 0}));
  }

  TEST(LevelAgreement, FinerNeighbourForbidsCoarsening)
  {
    std::vector<CellKey> leaves(row.begin() + 1, row.end() - 1);
    // refine root 0 twice along its right side
    for (const LatticePoint<2> corner : {LatticePoint<2>{{0, 0}}, LatticePoint<2>{{0, 8}}})
      leaves.push_back(make_key<2>(1, corner));
    for (int k = 0; k < 8; ++k)
      leaves.push_back(make_key<2>(2, {{8 + 4 * (k & 1), 4 * (k / 2)}}));
    const std::vector<std::uint8_t> level =
        agree_levels<2>(lattice, leaves, std::vector<std::uint8_t>(leaves.size(), 0));
    for (int i = 0; i < 4; ++i)
      EXPECT_EQ(level[i], 1) << "level 1 must wait until level 2 beside it is gone";
    for (int i = 6; i < 14; ++i)
      EXPECT_EQ(level[i], 1);
  }

  TEST(LevelAgreement, AdaptedLeavesStayInForestOrder)
  {
    const std::vector<CellKey> after = adapted_leaves<2>(lattice, row, agree({1, 0, 0, 0, 0, 0}));
    EXPECT_EQ(after,
              (std::vector<CellKey>{make_key<2>(1, {{0, 0}}), make_key<2>(1, {{8, 0}}), make_key<2>(1, {{0, 8}}),
                                    make_key<2>(1, {{8, 8}}), make_key<2>(0, {{16, 0}}), make_key<2>(0, {{32, 0}})}));
  }

  TEST(LevelAgreement, RefusesLevelsBeyondTheFinest)
  {
    EXPECT_THROW(agree({5, 0, 0, 0, 0, 0}), StateError);
    EXPECT_THROW(agree({0, 0}), StateError);
  }

  TEST(LevelAgreement, RandomTargetsFollowTheReference)
  {
    std::mt19937         random(3);
    std::vector<CellKey> leaves(row);
    for (int round = 0; round < 60; ++round)
      {
        std::vector<std::uint8_t>    target;
        std::vector<reference::Leaf> listed;
        for (const CellKey leaf : leaves)
          {
            const LatticePoint<2> p = key_point<2>(leaf);
            target.push_back(random() % 3 == 0 ? random() % 5 : round % 7 < 3 ? 0 : key_level(leaf));
            listed.push_back({key_level(leaf), p[0], p[1], target.back()});
          }
        leaves                      = adapted_leaves<2>(lattice, leaves, agree_levels<2>(lattice, leaves, target));
        std::vector<CellKey> sorted = leaves;
        std::sort(sorted.begin(), sorted.end());
        ASSERT_EQ(sorted, reference::round(lattice, listed)) << "round " << round;
      }
  }
} // namespace
