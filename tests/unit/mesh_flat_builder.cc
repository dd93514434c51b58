// SPDX-License-Identifier: LGPL-2.1-or-later
#include <whipple/error.h>
#include <whipple/mesh/flat_builder.h>

#include <gtest/gtest.h>

#include <algorithm>
#include <set>

namespace
{
  using namespace whipple;

  /// 2 x 2 coarse cells of which the upper right one is refined once.
  std::vector<CellKey>
  corner_refined()
  {
    return {make_key<2>(0, {{0, 0}}), make_key<2>(0, {{2, 0}}), make_key<2>(0, {{0, 2}}), make_key<2>(1, {{2, 2}}),
            make_key<2>(1, {{3, 2}}), make_key<2>(1, {{2, 3}}), make_key<2>(1, {{3, 3}})};
  }

  Lattice<2>
  two_by_two(int max_level)
  {
    return {Symmetry::axisymmetric, {{0., -1.}}, 0.5, {{2, 2}}, max_level};
  }

  FlatMesh<2>
  build(const Lattice<2> &lattice, const std::vector<CellKey> &keys, Cohesion cohesion = Cohesion::bonded)
  {
    return build_flat_mesh<2>(lattice, keys, static_cast<Index>(keys.size()), std::vector<std::uint8_t>(keys.size(), 0),
                              0, cohesion);
  }

  TEST(FlatBuilder, HangingNodesAndTheirMasters)
  {
    const FlatMesh<2> mesh = build(two_by_two(1), corner_refined());
    EXPECT_EQ(mesh.n_nodes, 9 + 5); // coarse lattice, four edge middles and the centre of the refined cell
    ASSERT_EQ(mesh.hanging.size(), 2u);
    for (std::size_t h = 0; h < mesh.hanging.size(); ++h)
      for (int d = 0; d < 2; ++d)
        EXPECT_DOUBLE_EQ(mesh.node_point[d][mesh.hanging[h]],
                         0.5 * (mesh.node_point[d][mesh.master[h][0]] + mesh.node_point[d][mesh.master[h][1]]));
  }

  TEST(FlatBuilder, EveryCellSideIsCoveredByItsSubfaces)
  {
    const FlatMesh<2> mesh = build(two_by_two(1), corner_refined());
    for (int axis = 0; axis < 2; ++axis)
      for (int side = 0; side < 2; ++side)
        for (Index c = 0; c < mesh.n_cells; ++c)
          {
            double length = 0;
            for (int s = 0; s < 2; ++s)
              if (const Index f = mesh.cell_face[2 * axis + side][2 * c + s]; f != none)
                {
                  const auto &faces = mesh.faces[axis];
                  EXPECT_EQ(faces.cell[1 - side][f], c);
                  const Index a = faces.node[2 * f], b = faces.node[2 * f + 1];
                  EXPECT_DOUBLE_EQ(mesh.node_point[axis][a], mesh.lower[axis][c] + side * mesh.size[c]);
                  length += mesh.node_point[1 - axis][b] - mesh.node_point[1 - axis][a];
                }
            EXPECT_DOUBLE_EQ(length, mesh.size[c]);
          }
  }

  TEST(FlatBuilder, HalfOfACoarseSideWithoutNeighbourIsAFaceOfItsOwn)
  {
    std::vector<CellKey> keys = corner_refined();
    keys.erase(keys.begin() + 3); // the fine cell touching both coarse neighbours
    const FlatMesh<2> mesh = build(two_by_two(1), keys);
    const Index       f    = mesh.cell_face[2 * 1 + 1][2 * 1 + 0]; // upper side of cell 1, lower half
    ASSERT_NE(f, none);
    EXPECT_EQ(mesh.faces[1].cell[1][f], none);
    EXPECT_EQ(mesh.faces[1].side[f], -1);
    EXPECT_EQ(mesh.faces[1].part[0][f], 0);
    EXPECT_DOUBLE_EQ(mesh.node_point[0][mesh.faces[1].node[2 * f + 1]], 1.5);
  }

  TEST(FlatBuilder, DomainSidesAreMarked)
  {
    const FlatMesh<2> mesh = build(two_by_two(1), corner_refined());
    for (int side = 0; side < 4; ++side)
      {
        const auto &faces  = mesh.faces[side / 2];
        double      length = 0;
        for (Index f = 0; f < faces.size(); ++f)
          if (faces.side[f] == side)
            length +=
                mesh.node_point[1 - side / 2][faces.node[2 * f + 1]] - mesh.node_point[1 - side / 2][faces.node[2 * f]];
        EXPECT_DOUBLE_EQ(length, 2.);
      }
  }

  TEST(FlatBuilder, FragmentsShareNothing)
  {
    const FlatMesh<2> mesh = build(two_by_two(1), corner_refined(), Cohesion::fragments);
    EXPECT_EQ(mesh.n_nodes, 7 * 4);
    EXPECT_TRUE(mesh.hanging.empty());
    EXPECT_EQ(mesh.faces[0].size(), 0);
    EXPECT_EQ(std::set<Index>(mesh.cell_node.begin(), mesh.cell_node.end()).size(), 28u);
  }

  TEST(FlatBuilder, CellsThatTouchInACornerOnlyAreNotJoined)
  {
    const FlatMesh<2> mesh = build(two_by_two(0), {make_key<2>(0, {{0, 0}}), make_key<2>(0, {{1, 1}})});
    EXPECT_EQ(mesh.n_nodes, 8);
  }

  TEST(FlatBuilder, CornersOfANodeFollowGeometryNotNumbering)
  {
    std::vector<CellKey> keys      = corner_refined();
    const auto           quadrants = [](const FlatMesh<2> &mesh) {
      std::vector<std::vector<CellKey>> all;
      for (Index n = 0; n < mesh.n_nodes; ++n)
        {
          all.emplace_back();
          for (Index i = mesh.node_corner_begin[n]; i < mesh.node_corner_begin[n + 1]; ++i)
            all.back().push_back(mesh.key[mesh.node_corner[i] / 4]);
        }
      std::sort(all.begin(), all.end());
      return all;
    };
    const auto reference = quadrants(build(two_by_two(1), keys));
    std::reverse(keys.begin(), keys.end());
    EXPECT_EQ(quadrants(build(two_by_two(1), keys)), reference);
  }

  TEST(FlatBuilder, RejectsOverlapAndImbalance)
  {
    std::vector<CellKey> keys = corner_refined();
    keys.push_back(make_key<2>(0, {{2, 2}}));
    EXPECT_THROW(build(two_by_two(1), keys), StateError);
    EXPECT_THROW(build(two_by_two(2), {make_key<2>(0, {{0, 0}}), make_key<2>(2, {{4, 0}})}), StateError);
  }
} // namespace
