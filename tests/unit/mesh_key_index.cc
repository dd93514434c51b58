// SPDX-License-Identifier: LGPL-2.1-or-later
#include <whipple/error.h>
#include <whipple/mesh/key_arithmetic.h>
#include <whipple/mesh/key_index.h>

#include <gtest/gtest.h>

namespace
{
  using namespace whipple;

  TEST(CellKeys, PackAndUnpack)
  {
    for (const int level : {0, 1, 7, 18})
      for (const LatticePoint<2> point : {LatticePoint<2>{{0, 0}}, LatticePoint<2>{{524287, 1}},
                                          LatticePoint<2>{{3, 524287}}, LatticePoint<2>{{262144, 262144}}})
        {
          const CellKey key = make_key<2>(level, point);
          EXPECT_EQ(key_level(key), level);
          EXPECT_EQ(key_point<2>(key), point);
        }
  }

  TEST(CellKeys, ChildrenAndAncestors)
  {
    const Lattice<2> lattice{Symmetry::planar, {}, 1., {{3, 2}}, 5};
    const CellKey    cell = make_key<2>(2, {{64 + 8, 32 + 16}});
    for (int child = 0; child < 4; ++child)
      {
        const CellKey key = child_key(lattice, cell, child);
        EXPECT_EQ(key, make_key<2>(3, {{72 + 4 * (child & 1), 48 + 4 * (child >> 1)}}));
        EXPECT_EQ(ancestor_key(lattice, key, 2), cell);
        EXPECT_EQ(ancestor_key(lattice, key, 0), make_key<2>(0, {{64, 32}}));
      }
  }

  TEST(CellKeys, LatticesThatDoNotFitAreRefused)
  {
    EXPECT_NO_THROW(require_packable<2>({Symmetry::planar, {}, 1., {{512, 1}}, 10}));
    EXPECT_THROW(require_packable<2>({Symmetry::planar, {}, 1., {{1, 513}}, 10}), InputError);
    EXPECT_THROW(require_packable<2>({Symmetry::planar, {}, 1., {{0, 1}}, 3}), InputError);
  }

  TEST(KeyIndex, FindsWhatWasInsertedWhileGrowing)
  {
    KeyIndex   index;
    const auto key = [](int i) { return make_key<2>(6, {{64 * (i % 100), 64 * (i / 100)}}); };
    for (int i = 0; i < 10000; ++i)
      EXPECT_EQ(index.insert(key(i), i), i);
    EXPECT_EQ(index.insert(key(77), 5), 77);
    EXPECT_EQ(index.size(), 10000u);
    for (int i = 0; i < 10000; ++i)
      EXPECT_EQ(index.find(key(i)), i);
    EXPECT_EQ(index.find(key(10000)), none);
    EXPECT_EQ(index.find(make_key<2>(5, {{0, 0}})), none);
    EXPECT_EQ(index.insert(0, 3), 3); // the first root cell's key is zero
    EXPECT_EQ(index.find(0), 3);
  }

  TEST(KeyIndex, RefusesDuplicates)
  {
    const std::vector<CellKey> keys{5, 9, 5};
    EXPECT_THROW(KeyIndex{std::span<const CellKey>(keys)}, StateError);
  }
} // namespace
