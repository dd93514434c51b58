// SPDX-License-Identifier: LGPL-2.1-or-later
#include <whipple/mesh/disjoint_sets.h>

#include <gtest/gtest.h>

namespace
{
  using namespace whipple;

  TEST(DisjointSets, TheRootIsTheSmallestNumberInWhateverOrderTheyGrow)
  {
    const std::vector<std::pair<int, int>> pairs{{7, 5}, {2, 9}, {5, 9}, {1, 3}, {3, 3}};
    for (const bool backwards : {false, true})
      {
        DisjointSets sets(10);
        for (std::size_t i = 0; i < pairs.size(); ++i)
          {
            const auto [a, b] = pairs[backwards ? pairs.size() - 1 - i : i];
            sets.unite(a, b);
          }
        const std::vector<std::size_t> expected{0, 1, 2, 1, 4, 2, 6, 2, 8, 2};
        for (std::size_t i = 0; i < 10; ++i)
          {
            EXPECT_EQ(sets.root(i), expected[i]);
            EXPECT_EQ(sets.is_root(i), expected[i] == i);
          }
      }
  }
} // namespace
