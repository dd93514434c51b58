// SPDX-License-Identifier: LGPL-2.1-or-later
#include <whipple/mesh/flat_partition.h>

#include <gtest/gtest.h>

namespace
{
  using namespace whipple;

  const Lattice<2> lattice{Symmetry::planar, {}, 1., {{2, 1}}, 1};

  TEST(Halo, OneRankHasNothingToExchange)
  {
    const std::vector<CellKey>      leaves{make_key<2>(0, {{0, 0}}), make_key<2>(0, {{2, 0}})};
    const std::vector<std::uint8_t> active{1, 1};
    const auto part = flatten_leaves<2>(MPI_COMM_SELF, lattice, leaves, active, 3, Cohesion::bonded);
    EXPECT_EQ(part->mesh.n_owned, 2);
    EXPECT_EQ(part->mesh.n_cells, 2);

    std::vector<double>        cell{1., 2.}, node(part->mesh.n_nodes, 3.), corner(8, 4.);
    std::vector<double> *const cells[]{&cell}, *const nodes[]{&node}, *const corners[]{&corner};
    part->halo.exchange(cells, nodes);
    part->halo.exchange_corners(corners);
    EXPECT_EQ(cell, (std::vector<double>{1., 2.}));
    EXPECT_EQ(node, std::vector<double>(part->mesh.n_nodes, 3.));
    EXPECT_EQ(corner, std::vector<double>(8, 4.));
  }

  TEST(Halo, ARankMayBeItsOwnNeighbour)
  {
    // two separate cells; pretend the second is a halo copy whose owner's values are those of the first
    const FlatMesh<2>   mesh = build_flat_mesh<2>(lattice, {make_key<2>(0, {{0, 0}}), make_key<2>(0, {{2, 0}})}, 1,
                                                {0, 1}, 1, Cohesion::fragments);
    const Halo<2>       halo(MPI_COMM_SELF, mesh, {{0, {0}, {1}}});
    std::vector<double> cell{5., 0.}, node(8, 0.), corner(8, 0.);
    for (int k = 0; k < 4; ++k)
      {
        node[mesh.cell_node[k]] = 10. + k;
        corner[k]               = 20. + k;
      }
    std::vector<double> *const cells[]{&cell}, *const nodes[]{&node}, *const corners[]{&corner};
    for (int repeat = 0; repeat < 2; ++repeat)
      {
        halo.exchange(cells, nodes);
        halo.exchange_corners(corners);
      }
    EXPECT_EQ(cell[1], 5.);
    for (int k = 0; k < 4; ++k)
      {
        EXPECT_EQ(node[mesh.cell_node[4 + k]], 10. + k);
        EXPECT_EQ(corner[4 + k], 20. + k);
      }
  }

  TEST(FlattenLeaves, KeepsActiveLeavesInForestOrder)
  {
    const std::vector<CellKey>      leaves{make_key<2>(1, {{0, 0}}), make_key<2>(1, {{1, 0}}), make_key<2>(1, {{0, 1}}),
                                      make_key<2>(1, {{1, 1}}), make_key<2>(0, {{2, 0}})};
    const std::vector<std::uint8_t> active{1, 0, 1, 1, 0};
    const auto part = flatten_leaves<2>(MPI_COMM_SELF, lattice, leaves, active, 0, Cohesion::bonded);
    EXPECT_EQ(part->leaf_of_cell, (std::vector<Index>{0, 2, 3}));
    EXPECT_EQ(part->mesh.key, (std::vector<CellKey>{leaves[0], leaves[2], leaves[3]}));
  }
} // namespace
