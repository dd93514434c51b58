// SPDX-License-Identifier: LGPL-2.1-or-later
// Which cell holds a point: on a lattice, and among elements that are deformed, touch or overlap.
#include <whipple/diagnostics/mesh_point.h>

#include <gtest/gtest.h>

#include <cmath>

namespace
{
  using namespace whipple;

  /// Two by two cells of 1 cm from (-1, 0), the last of them cut in four; every cell holds material.
  struct Field
  {
    Lattice<2>  lattice{Symmetry::planar, {{-1., 0.}}, 0.5, {{2, 2}}, 1};
    FlatMesh<2> mesh;
    State<2>    state;

    explicit Field(Cohesion cohesion = Cohesion::bonded)
    {
      std::vector<CellKey> keys{make_key<2>(0, {{0, 0}}), make_key<2>(0, {{2, 0}}), make_key<2>(0, {{0, 2}})};
      for (int k = 0; k < 4; ++k)
        keys.push_back(make_key<2>(1, {{2 + k % 2, 2 + k / 2}}));
      const auto n   = static_cast<Index>(keys.size());
      mesh           = build_flat_mesh(lattice, keys, n, std::vector<std::uint8_t>(n, 0), 0, Bonds(cohesion));
      state.position = mesh.node_point;
      state.material.resize(1);
      state.material[0].mass.assign(n, 1.);
    }
  };

  TEST(MeshPoint, IsInOneCellOfALattice)
  {
    const Field field;
    const auto  cell = [&](double x, double y) {
      return find_in_lattice<2>(field.lattice, field.mesh, field.state, {{x, y}}).cell;
    };
    EXPECT_EQ(cell(-0.5, 0.5), 0);
    EXPECT_EQ(cell(0., 0.5), 1); // on a face: the cell above
    EXPECT_EQ(cell(0., 1.), 3);
    EXPECT_EQ(cell(0.49, 1.49), 3);
    EXPECT_EQ(cell(0.5, 1.49), 4);
    EXPECT_EQ(cell(1., 2.), 6); // the upper end of the domain
    EXPECT_EQ(cell(-1., 0.), 0);
    EXPECT_EQ(cell(-1.001, 0.), none);
    EXPECT_EQ(cell(0., 2.001), none);
    EXPECT_EQ(cell(std::nan(""), 0.), none);
    const MeshPoint<2> point = find_in_lattice<2>(field.lattice, field.mesh, field.state, {{0.6, 1.1}});
    EXPECT_EQ(point.cell, 4);
    EXPECT_NEAR(point.local[0], 0.2, 1e-15);
    EXPECT_NEAR(point.local[1], 0.2, 1e-15);
  }

  TEST(MeshPoint, NeedsMaterial)
  {
    Field field;
    field.state.material[0].mass[1] = 0;
    EXPECT_EQ(find_in_lattice<2>(field.lattice, field.mesh, field.state, {{0.5, 0.5}}).cell, none);
    EXPECT_EQ(find_in_elements<2>(field.mesh, field.state, {{0.5, 0.5}}).cell, none);
  }

  /// The map (x + 0.2 y, y + 0.1 x y) is bilinear on every cell, so the inverse is known.
  TEST(MeshPoint, IsFoundInDeformedElements)
  {
    Field      field;
    const auto map = [](double x, double y) { return Vector<2>{{x + 0.2 * y, y + 0.1 * x * y}}; };
    for (Index n = 0; n < field.mesh.n_nodes; ++n)
      {
        const Vector<2> x = map(field.mesh.node_point[0][n], field.mesh.node_point[1][n]);
        for (int d = 0; d < 2; ++d)
          field.state.position[d][n] = x[d];
      }
    for (Index c = 0; c < field.mesh.n_cells; ++c)
      for (const double a : {0.03, 0.5, 0.97})
        for (const double b : {0.08, 0.6})
          {
            const Vector<2> x =
                map(field.mesh.lower[0][c] + a * field.mesh.size[c], field.mesh.lower[1][c] + b * field.mesh.size[c]);
            const auto point = find_in_elements<2>(field.mesh, field.state, x);
            ASSERT_EQ(point.cell, c);
            EXPECT_NEAR(point.local[0], a, 1e-12);
            EXPECT_NEAR(point.local[1], b, 1e-12);
            const Vector<2> again = at_point<2>(field.mesh, field.state.position, point);
            EXPECT_NEAR(again[0], x[0], 1e-14);
            EXPECT_NEAR(again[1], x[1], 1e-14);
          }
    EXPECT_EQ(find_in_elements<2>(field.mesh, field.state, map(1.01, 0.5)).cell, none);
  }

  /// Pieces that overlap: the one of least key, wherever it stands in the array.
  TEST(MeshPoint, IsInTheElementOfLeastKey)
  {
    Field field(Cohesion::fragments);
    for (const Index c : {1, 2}) // onto the first
      for (int k = 0; k < 4; ++k)
        for (int d = 0; d < 2; ++d)
          field.state.position[d][field.mesh.cell_node[4 * c + k]] =
              field.state.position[d][field.mesh.cell_node[k]] + 0.1;
    EXPECT_EQ(find_in_elements<2>(field.mesh, field.state, {{-0.5, 0.5}}).cell, 0);
    EXPECT_LT(field.mesh.key[1], field.mesh.key[2]);
    EXPECT_EQ(find_in_elements<2>(field.mesh, field.state, {{0.05, 1.05}}).cell, 1);
  }
} // namespace
