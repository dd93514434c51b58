// SPDX-License-Identifier: LGPL-2.1-or-later
#include "../unit/projection_fixture.h"

#include <whipple/output/snapshot.h>
#include <whipple/projection/to_eulerian.h>

#include <gtest/gtest.h>

#include <algorithm>

namespace
{
  using namespace whipple;
  using namespace whipple::projection_test;

  /// Cut [0, n) in as many slices as there are ranks.
  std::pair<Index, Index>
  my_slice(Index n)
  {
    int rank, ranks;
    MPI_Comm_rank(MPI_COMM_WORLD, &rank);
    MPI_Comm_size(MPI_COMM_WORLD, &ranks);
    return {n * rank / ranks, n * (rank + 1) / ranks};
  }

  /// Halo of a mesh of which every rank owns its slice of the keys and sees all others.
  Halo<2>
  halo_of(const FlatMesh<2> &mesh, const std::vector<CellKey> &keys)
  {
    int me, ranks;
    MPI_Comm_rank(MPI_COMM_WORLD, &me);
    MPI_Comm_size(MPI_COMM_WORLD, &ranks);
    const Index n = static_cast<Index>(keys.size());
    // the local index of a key; owners send in the order of keys
    const auto slice_of = [&](int rank) {
      std::vector<CellKey> own(keys.begin() + n * rank / ranks, keys.begin() + n * (rank + 1) / ranks);
      std::sort(own.begin(), own.end());
      std::vector<Index> cells;
      for (const CellKey key : own)
        cells.push_back(static_cast<Index>(std::find(mesh.key.begin(), mesh.key.end(), key) - mesh.key.begin()));
      return cells;
    };
    std::vector<Halo<2>::Neighbour> neighbours;
    for (int rank = 0; rank < ranks; ++rank)
      if (rank != me)
        neighbours.push_back({rank, slice_of(me), slice_of(rank)});
    return Halo<2>(MPI_COMM_WORLD, mesh, std::move(neighbours));
  }
} // namespace

TEST(ProjectionRanks, CellsGetTheSameBitsHoweverElementsAndCellsAreShared)
{
  // the same cloud on every rank
  const auto grid  = lattice(Symmetry::axisymmetric, 6, 1);
  const auto cloud = mesh_of(grid, uniform_keys(grid, 1), Cohesion::fragments);
  State<2>   state = blank_state(cloud);
  Random     random(51);
  fill_randomly(state, random);
  set_velocities(cloud, state, 0.2, random);
  for (Index node = 0; node < cloud.n_nodes; ++node)
    for (int d = 0; d < 2; ++d)
      if (d == 1 || state.position[0][node] > 0)
        state.position[d][node] += 0.01 * random(-1., 1.);
  const auto layout = CellPacketLayout<2>::of(state);
  const auto all    = elements_of<2>(layout, cloud, state);

  // each rank brings a slice of the elements
  const auto [first, last] = my_slice(static_cast<Index>(all.size()));
  const auto gathered =
      gather_elements<2>(MPI_COMM_WORLD, layout, std::vector<Element<2>>(all.begin() + first, all.begin() + last));
  const auto reference = gather_elements<2>(MPI_COMM_SELF, layout, all);
  ASSERT_EQ(gathered.size(), reference.size());
  for (std::size_t i = 0; i < gathered.size(); ++i)
    {
      EXPECT_EQ(gathered[i].key, reference[i].key);
      EXPECT_EQ(gathered[i].position, reference[i].position);
      EXPECT_EQ(gathered[i].corner_mass, reference[i].corner_mass);
      EXPECT_EQ(gathered[i].packet, reference[i].packet);
    }

  // and owns a slice of the cells, the rest being halo
  const auto serial_mesh  = mesh_of(grid, hanging_keys(grid));
  State<2>   serial_state = blank_state(serial_mesh);
  const auto serial =
      to_eulerian<2>(MPI_COMM_SELF, grid, layout, reference, *RepresentationRegistry::make("distended"), serial_mesh,
                     Halo<2>(MPI_COMM_SELF, serial_mesh, {}), {}, {}, KineticLoss::heat, serial_state);

  auto keys               = serial_mesh.key;
  const auto [begin, end] = my_slice(serial_mesh.n_cells);
  const Index n_owned     = end - begin;
  std::rotate(keys.begin(), keys.begin() + begin, keys.end());
  std::vector<std::uint8_t> layer(keys.size(), 1);
  std::fill_n(layer.begin(), n_owned, 0);
  const auto mesh   = build_flat_mesh<2>(grid, keys, n_owned, layer, 1, Cohesion::bonded);
  State<2>   mine   = blank_state(mesh);
  const auto report = to_eulerian<2>(MPI_COMM_WORLD, grid, layout, gathered, *RepresentationRegistry::make("distended"),
                                     mesh, halo_of(mesh, serial_mesh.key), {}, {}, KineticLoss::heat, mine);
  for (Index cell = 0; cell < n_owned; ++cell)
    for (int m = 0; m < 2; ++m)
      {
        EXPECT_EQ(mine.material[m].mass[cell], serial_state.material[m].mass[begin + cell]);
        EXPECT_EQ(mine.material[m].energy[cell], serial_state.material[m].energy[begin + cell]);
        for (int k = 0; k < 4; ++k)
          for (int d = 0; d < 2; ++d)
            EXPECT_EQ(mine.velocity[d][mesh.cell_node[4 * cell + k]],
                      serial_state.velocity[d][serial_mesh.cell_node[4 * (begin + cell) + k]]);
      }
  const auto lost = [](const LaidDown<2> &laid) { return *laid.bookings.of(laid_down::projection).converted; };
  EXPECT_NEAR(lost(report), lost(serial), 1e-13 * serial.elements.kinetic_energy);
  EXPECT_EQ(report.bookings.of(laid_down::beyond).left->mass, serial.bookings.of(laid_down::beyond).left->mass);
}

TEST(ProjectionRanks, ARankWithoutElementsCarriesTheSameQuantities)
{
  const auto     grid = lattice(Symmetry::axisymmetric, 6, 1);
  const auto     all  = mesh_of(grid, uniform_keys(grid, 1));
  const State<2> like = blank_state(all);
  ASSERT_TRUE(like.material[0].has_voids());

  // the last rank keeps cells, so that on one rank there is nothing but them
  int rank, ranks;
  MPI_Comm_rank(MPI_COMM_WORLD, &rank);
  MPI_Comm_size(MPI_COMM_WORLD, &ranks);
  const bool     has_cells = rank == ranks - 1;
  const auto     mesh  = mesh_of(grid, has_cells ? uniform_keys(grid, 1) : std::vector<CellKey>(), Cohesion::fragments);
  const State<2> state = empty_state_like<2>(like, mesh);
  EXPECT_EQ(CellPacketLayout<2>::of(state).size(), CellPacketLayout<2>::of(like).size());
  EXPECT_EQ(CellPacketLayout<2>::of(state).has_voids, CellPacketLayout<2>::of(like).has_voids);

  // what then comes from there is still complete; so are the fields written, which waited for each other once
  const auto elements = gather_elements<2>(MPI_COMM_WORLD, CellPacketLayout<2>::of(state),
                                           elements_of<2>(CellPacketLayout<2>::of(state), mesh, state));
  EXPECT_TRUE(elements.empty()); // no material yet
  const auto fields_shown = [](const FlatMesh<2> &m, const State<2> &s) {
    Derived derived;
    derived.material.resize(s.material.size());
    for (DerivedMaterial &material : derived.material)
      material.pressure.assign(m.n_cells, 0.);
    return take_snapshot<2>(m, s, derived, {"a", "b"}, {}, {.empty_cells = true}).fields.size();
  };
  EXPECT_EQ(fields_shown(mesh, state), fields_shown(all, like));
}
