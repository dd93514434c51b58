// SPDX-License-Identifier: LGPL-2.1-or-later
#include <whipple/error.h>
#include <whipple/mesh/key_arithmetic.h>
#include <whipple/mesh/refinement_map.h>

#include <gtest/gtest.h>

#include <limits>
#include <random>

namespace
{
  using namespace whipple;

  const Lattice<2> lattice{Symmetry::planar, {{-1., 2.}}, 0.25, {{2, 3}}, 5}; // 64 x 96 finest cells

  struct Box
  {
    int             level, buffer;
    LatticePoint<2> lower, upper;
  };

  /// The definition by exhaustion: one entry per finest cell.
  std::vector<int>
  painted(const std::vector<Box> &boxes)
  {
    std::vector<int> level(64 * 96, -1);
    for (const Box &box : boxes)
      {
        const int margin = box.buffer << (5 - box.level);
        const int block  = std::min(4 << (5 - box.level), 32); // never larger than a root cell
        for (int y = 0; y < 96; ++y)
          for (int x = 0; x < 64; ++x)
            {
              const int  bx = x / block * block, by = y / block * block;
              const bool inside = bx < box.upper[0] + margin && bx + block > box.lower[0] - margin &&
                                  by < box.upper[1] + margin && by + block > box.lower[1] - margin;
              if (inside)
                level[64 * y + x] = std::max(level[64 * y + x], box.level);
            }
      }
    return level;
  }

  void
  expect_painted(const RefinementMap<2> &map, const std::vector<int> &level)
  {
    for (int leaf_level = 0; leaf_level <= 5; ++leaf_level)
      for (int y = 0, step = lattice.extent(leaf_level); y < 96; y += step)
        for (int x = 0; x < 64; x += step)
          {
            int highest = -1;
            for (int j = y; j < y + step; ++j)
              for (int i = x; i < x + step; ++i)
                highest = std::max(highest, level[64 * j + i]);
            const CellKey leaf = make_key<2>(leaf_level, {{x, y}});
            ASSERT_EQ(map.target_level(leaf), std::max(highest, 0)) << leaf_level << ' ' << x << ' ' << y;
            ASSERT_EQ(map.touched(leaf), highest >= 0) << leaf_level << ' ' << x << ' ' << y;
          }
  }

  TEST(RefinementMap, AgreesWithPaintingFinestCellsInAnyOrder)
  {
    std::mt19937 random(7);
    for (int trial = 0; trial < 10; ++trial)
      {
        std::vector<Box> boxes;
        for (int b = 0; b < 5; ++b)
          {
            Box box;
            box.level  = static_cast<int>(random() % 6);
            box.buffer = static_cast<int>(random() % 3);
            for (int d = 0; d < 2; ++d)
              {
                box.lower[d] = static_cast<int>(random() % 130) - 20;
                box.upper[d] = box.lower[d] + 1 + static_cast<int>(random() % 9);
              }
            boxes.push_back(box);
          }
        RefinementMap<2> map(lattice), reversed(lattice);
        for (std::size_t b = 0; b < boxes.size(); ++b)
          {
            const Box &box = boxes[b], &other = boxes[boxes.size() - 1 - b];
            map.request(box.level, box.lower, box.upper, box.buffer);
            reversed.request(other.level, other.lower, other.upper, other.buffer);
          }
        map.synchronise(MPI_COMM_SELF);
        reversed.synchronise(MPI_COMM_SELF);
        expect_painted(map, painted(boxes));
        expect_painted(reversed, painted(boxes));
      }
  }

  TEST(RefinementMap, BoxesInCentimetres)
  {
    RefinementMap<2> map(lattice);
    map.request(5, Vector<2>{{-0.9, 2.1}}, Vector<2>{{-0.6, 2.2}}, 0); // finest cells [0,2) x [0,1)
    map.request(5, Vector<2>{{3., 10.}}, Vector<2>{{3., 10.}}, 0);     // a point: the finest cell (16, 32)
    map.request(5, Vector<2>{{1e30, 0.}}, Vector<2>{{1e31, 99.}}, 3);  // far outside
    map.synchronise(MPI_COMM_SELF);
    expect_painted(map, painted({{5, 0, {{0, 0}}, {{2, 1}}}, {5, 0, {{16, 32}}, {{17, 33}}}}));
  }

  TEST(RefinementMap, HysteresisOfABlock)
  {
    // a front that moves inside one block of 4 cells changes nothing
    RefinementMap<2> before(lattice), after(lattice);
    before.request(5, LatticePoint<2>{{20, 20}}, LatticePoint<2>{{21, 21}}, 2);
    after.request(5, LatticePoint<2>{{21, 21}}, LatticePoint<2>{{22, 22}}, 2);
    before.synchronise(MPI_COMM_SELF);
    after.synchronise(MPI_COMM_SELF);
    EXPECT_EQ(before.n_blocks(), 4u);
    expect_painted(after, painted({{5, 2, {{20, 20}}, {{21, 21}}}}));
  }

  TEST(RefinementMap, ClearForgets)
  {
    RefinementMap<2> map(lattice);
    map.request(3, LatticePoint<2>{{0, 0}}, LatticePoint<2>{{64, 96}}, 0);
    map.synchronise(MPI_COMM_SELF);
    EXPECT_EQ(map.target_level(make_key<2>(0, {{32, 64}})), 3);
    map.clear();
    map.synchronise(MPI_COMM_SELF);
    EXPECT_FALSE(map.touched(make_key<2>(0, {{32, 64}})));
  }

  TEST(RefinementMap, RefusesNonsense)
  {
    RefinementMap<2> map(lattice);
    const double     nan = std::numeric_limits<double>::quiet_NaN();
    EXPECT_THROW(map.request(6, LatticePoint<2>{{0, 0}}, LatticePoint<2>{{1, 1}}, 0), StateError);
    EXPECT_THROW(map.request(1, LatticePoint<2>{{0, 0}}, LatticePoint<2>{{0, 1}}, 0), StateError);
    EXPECT_THROW(map.request(1, Vector<2>{{0., nan}}, Vector<2>{{1., 1.}}, 0), StateError);
    EXPECT_THROW(map.request(1, Vector<2>{{0., 3.}}, Vector<2>{{-1., 3.}}, 0), StateError);
  }
} // namespace
