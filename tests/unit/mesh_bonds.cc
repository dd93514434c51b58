// SPDX-License-Identifier: LGPL-2.1-or-later
#include "projection_fixture.h"

#include <whipple/error.h>
#include <whipple/hydro/fragment_release.h>
#include <whipple/mesh/key_index.h>
#include <whipple/projection/intact_cells.h>

#include <gtest/gtest.h>

#include <algorithm>
#include <map>
#include <set>

namespace
{
  using namespace whipple;
  using namespace whipple::projection_test;

  const Lattice<2> grid = lattice(Symmetry::axisymmetric, 9, 1);

  /// About a third of the cells broken.
  std::vector<std::uint8_t>
  random_flags(std::size_t n, unsigned seed)
  {
    Random                    random(seed);
    std::vector<std::uint8_t> intact(n);
    for (auto &flag : intact)
      flag = random(0., 1.) < 0.67;
    return intact;
  }

  using Corner = std::pair<CellKey, int>; ///< of which cell, which one

  std::set<Corner>
  corners_of(const FlatMesh<2> &mesh, Index node)
  {
    std::set<Corner> corners;
    for (Index i = mesh.node_corner_begin[node]; i < mesh.node_corner_begin[node + 1]; ++i)
      corners.insert({mesh.key[mesh.node_corner[i] / 4], mesh.node_corner[i] % 4});
    return corners;
  }

  /// Nodes as the corners they are made of.
  std::set<std::set<Corner>>
  nodes_of(const FlatMesh<2> &mesh)
  {
    std::set<std::set<Corner>> nodes;
    for (Index n = 0; n < mesh.n_nodes; ++n)
      nodes.insert(corners_of(mesh, n));
    return nodes;
  }

  /// Hanging nodes with their two masters.
  std::set<std::vector<std::set<Corner>>>
  hanging_of(const FlatMesh<2> &mesh)
  {
    std::set<std::vector<std::set<Corner>>> hanging;
    for (std::size_t h = 0; h < mesh.hanging.size(); ++h)
      hanging.insert({corners_of(mesh, mesh.hanging[h]), corners_of(mesh, mesh.master[h][0]),
                      corners_of(mesh, mesh.master[h][1])});
    return hanging;
  }

  /// Faces as the cells on their two sides (0: none), parts and domain side.
  std::multiset<std::vector<long>>
  faces_of(const FlatMesh<2> &mesh)
  {
    std::multiset<std::vector<long>> all;
    for (int axis = 0; axis < 2; ++axis)
      for (Index f = 0; f < mesh.faces[axis].size(); ++f)
        {
          std::vector<long> face{axis, mesh.faces[axis].side[f]};
          for (int s = 0; s < 2; ++s)
            {
              const Index c = mesh.faces[axis].cell[s][f];
              face.push_back(c == none ? -1 : static_cast<long>(mesh.key[c]));
              face.push_back(mesh.faces[axis].part[s][f]);
            }
          all.insert(face);
        }
    return all;
  }

  TEST(MeshBonds, IntactCellsAreBondedAsIfTheBrokenOnesWereNotThere)
  {
    for (unsigned seed = 1; seed <= 20; ++seed)
      {
        const auto           keys   = hanging_keys(grid);
        const auto           intact = random_flags(keys.size(), seed);
        const FlatMesh<2>    mesh   = mesh_of(grid, keys, Bonds(intact));
        std::vector<CellKey> whole;
        for (std::size_t c = 0; c < keys.size(); ++c)
          if (intact[c])
            whole.push_back(keys[c]);
        const FlatMesh<2> rest = mesh_of(grid, whole);
        ASSERT_FALSE(rest.hanging.empty());

        auto expected = nodes_of(rest);
        for (Index c = 0; c < mesh.n_cells; ++c)
          if (!intact[c])
            for (int k = 0; k < 4; ++k)
              expected.insert({{mesh.key[c], k}});
        EXPECT_EQ(nodes_of(mesh), expected);
        EXPECT_EQ(mesh.n_nodes, static_cast<Index>(expected.size()));
        EXPECT_EQ(hanging_of(mesh), hanging_of(rest));
        EXPECT_EQ(faces_of(mesh), faces_of(rest));
        EXPECT_EQ(mesh.intact, intact);
      }
  }

  TEST(MeshBonds, AllIntactIsBondedAndAllBrokenIsFragments)
  {
    const auto keys = hanging_keys(grid);
    for (const int flag : {0, 1})
      {
        const FlatMesh<2> given   = mesh_of(grid, keys, Bonds(std::vector<std::uint8_t>(keys.size(), flag)));
        const FlatMesh<2> uniform = mesh_of(grid, keys, flag ? Cohesion::bonded : Cohesion::fragments);
        EXPECT_EQ(given.cell_node, uniform.cell_node);
        EXPECT_EQ(given.hanging, uniform.hanging);
        EXPECT_EQ(given.cell_face, uniform.cell_face);
        EXPECT_EQ(given.intact, uniform.intact);
      }
  }

  TEST(MeshBonds, GradedWithoutFlagsAndFlagsForOtherCellsAreRefused)
  {
    EXPECT_THROW(Bonds{Cohesion::graded}, StateError);
    EXPECT_THROW(mesh_of(grid, hanging_keys(grid), Bonds(std::vector<std::uint8_t>{1, 1})), StateError);
  }

  /// One material over all cells of a small uniform mesh.
  struct Body
  {
    Lattice<2>  square = lattice(Symmetry::planar, 3, 0);
    FlatMesh<2> mesh;
    State<2>    state;

    explicit Body(const Bonds &bonds = Cohesion::bonded)
      : mesh(mesh_of(square, uniform_keys(square, 0), bonds))
      , state(blank_state(mesh))
    {
      for (Index c = 0; c < mesh.n_cells; ++c)
        set_material(state.material[0], c, state.volume[c], 2.7, 0.001, 0.);
    }
  };

  TEST(IntactCells, VoidsInsideAndOutsideTheMaterialCount)
  {
    Body b;
    b.state.material[0].void_fraction[2] = 0.16;
    b.state.material[0].volume[5] *= 0.9; // a tenth of open void
    b.state.material[0].void_fraction[5] = 0.05;
    b.state.material[0].void_fraction[7] = 0.14;
    BreakCriteria criteria;
    criteria.void_fraction = 0.145; // 1 - 0.9 * 0.95
    const auto intact      = intact_cells(b.mesh, b.state, criteria);
    for (Index c = 0; c < 9; ++c)
      EXPECT_EQ(intact[c], c != 2) << c;
    criteria.void_fraction = 0.144;
    EXPECT_EQ(intact_cells(b.mesh, b.state, criteria)[5], 0);
  }

  TEST(IntactCells, DamageOfTheHeaviestMaterialDecidesWhereItIsCarried)
  {
    Body b;
    b.state.index.damage = 0; // the fixture's first field
    b.state.material[0].fields[0].value.assign(9, 0.1);
    b.state.material[0].void_fraction[1]   = 0.9; // of no concern
    b.state.material[0].fields[0].value[3] = 0.5;
    b.state.material[0].fields[0].value[4] = 0.49;
    const double half                      = 0.5 * b.state.volume[6];
    set_material(b.state.material[0], 6, half, 2.7, 0.001, 0.);
    set_material(b.state.material[1], 6, half, 7.8, 0.001, 0.);
    b.state.material[0].fields[0].value[6] = 0.;
    b.state.material[1].fields[0].value[6] = 1.;
    const auto intact                      = intact_cells(b.mesh, b.state, {});
    for (Index c = 0; c < 9; ++c)
      EXPECT_EQ(intact[c], c != 3 && c != 6) << c;
  }

  TEST(IntactCells, ACellAboutToFoldBreaks)
  {
    Body b;
    // corner 3 of the middle cell moves towards corner 0: its Jacobian over the mean is (1 - 2 s)/(1 - s)
    const Index n = b.mesh.cell_node[4 * 4 + 3];
    for (const auto &[s, whole] : {std::pair(0.43, 1), std::pair(0.45, 0)})
      {
        for (int d = 0; d < 2; ++d)
          b.state.position[d][n] = b.mesh.node_point[d][n] - s * b.mesh.size[4];
        EXPECT_EQ(intact_cells(b.mesh, b.state, {})[4], whole) << s; // 0.2 at s = 4/9
      }
  }

  TEST(FragmentRelease, CellsThatShareNodesAreLeftAlone)
  {
    std::vector<std::uint8_t> flags(9, 1);
    flags[4] = 0;
    Body b{Bonds(flags)};
    for (const Index c : {Index(0), Index(4)}) // corner 3 of both is on its way through corner 0
      for (int d = 0; d < 2; ++d)
        b.state.velocity[d][b.mesh.cell_node[4 * c + 3]] = -1.;
    const auto        before = node_totals(b.state).internal_energy;
    const Released<2> report = release_fragments<2>(b.mesh, {}, b.state, 0.09);
    EXPECT_EQ(report.number, 1);
    const double mass = 2.7 * b.state.volume[4]; // (m/4) (1/2 - 1/8) of each component's square turns into heat
    EXPECT_NEAR(*report.booking.converted, 2. * mass * (0.125 - 0.03125), 1e-15 * mass);
    EXPECT_NEAR(node_totals(b.state).internal_energy - before, *report.booking.converted, 1e-14 * before);
    for (int k = 0; k < 4; ++k)
      EXPECT_NEAR(b.state.velocity[0][b.mesh.cell_node[16 + k]], -0.25, 1e-15);
    EXPECT_EQ(b.state.velocity[0][b.mesh.cell_node[3]], -1.);
  }
} // namespace
