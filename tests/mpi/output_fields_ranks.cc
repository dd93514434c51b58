// SPDX-License-Identifier: LGPL-2.1-or-later
#include <deal.II/base/hdf5.h>
#include <deal.II/lac/full_matrix.h>

#include <whipple/error.h>
#include <whipple/mesh/flat_builder.h>
#include <whipple/output/field_output.h>
#include <whipple/output/output_directory.h>

#include <gtest/gtest.h>

#include <filesystem>
#include <fstream>
#include <string>
#include <vector>

namespace
{
  using namespace whipple;
  namespace fs = std::filesystem;

  int
  rank_of_this()
  {
    int rank = 0;
    MPI_Comm_rank(MPI_COMM_WORLD, &rank);
    return rank;
  }

  /// Rank r has the unit cells (r, 0) .. (r, n - 1), all full of one material at rest.
  FlatMesh<2>
  column_of_cells(int column, int n)
  {
    Lattice<2> lattice;
    lattice.roots = {{8, 8}};
    std::vector<CellKey> keys;
    for (int j = 0; j < n; ++j)
      keys.push_back(make_key<2>(0, {{column, j}}));
    return build_flat_mesh<2>(lattice, keys, n, std::vector<std::uint8_t>(keys.size(), 0), 0, Cohesion::bonded);
  }

  State<2>
  solid(const FlatMesh<2> &mesh)
  {
    State<2>          state;
    const std::size_t n = static_cast<std::size_t>(mesh.n_cells);
    state.position      = mesh.node_point;
    for (auto &component : state.velocity)
      component.assign(mesh.n_nodes, 0.);
    state.node_mass.assign(mesh.n_nodes, 1.);
    state.volume.assign(n, 1.);
    MaterialState material;
    for (auto *values : {&material.volume, &material.mass, &material.density, &material.energy})
      values->assign(n, 1.);
    state.material.push_back(material);
    return state;
  }

  fs::path
  fresh_directory(const std::string &name)
  {
    int ranks = 1;
    MPI_Comm_size(MPI_COMM_WORLD, &ranks); // the same test may be running on another number of ranks
    const fs::path directory = fs::current_path() / (name + std::to_string(ranks));
    MPI_Barrier(MPI_COMM_WORLD);
    if (rank_of_this() == 0)
      fs::remove_all(directory);
    MPI_Barrier(MPI_COMM_WORLD);
    return directory;
  }

  /// Every cell has the corners of its owner's column.
  void
  check_columns(const std::string &path, int n_cells)
  {
    dealii::HDF5::File file(path, dealii::HDF5::File::FileAccessMode::open);
    const auto         owner = file.open_dataset("rank").read<std::vector<float>>();
    const auto         nodes = file.open_dataset("nodes").read<dealii::FullMatrix<double>>();
    const auto         cells = file.open_dataset("cells").read<dealii::FullMatrix<double>>();
    ASSERT_EQ(owner.size(), static_cast<std::size_t>(n_cells));
    for (int c = 0; c < n_cells; ++c)
      {
        EXPECT_EQ(nodes(static_cast<unsigned int>(cells(c, 0)), 0), owner[c]);
        EXPECT_EQ(nodes(static_cast<unsigned int>(cells(c, 2)), 0), owner[c] + 1.);
      }
  }

  TEST(FieldOutputOnRanks, OwnersWriteTheirPartAndARankWithoutCellsNothing)
  {
    int ranks = 1;
    MPI_Comm_size(MPI_COMM_WORLD, &ranks);
    const int         rank  = rank_of_this();
    const FlatMesh<2> mesh  = column_of_cells(rank, ranks == 1 ? 1 : rank); // of several ranks the first is empty
    const State<2>    state = solid(mesh);
    const int         total = ranks == 1 ? 1 : ranks * (ranks - 1) / 2;

    const fs::path directory = fresh_directory("whipple_field_output_ranks_");
    Derived        pressures;
    pressures.material.emplace_back().pressure.assign(state.volume.size(), 1.);
    FieldOutput<2> output(directory.string(), {"aluminium"}, {.vtu = true}, MPI_COMM_WORLD);
    output.write(mesh, state, pressures, "flight");
    MPI_Barrier(MPI_COMM_WORLD);

    if (rank == 0) // HDF5 locks a file that is open
      check_columns((directory / "fields/fields-00000.h5").string(), total);
    EXPECT_TRUE(fs::exists(directory / "fields/fields-00000.vtu"));
    MPI_Barrier(MPI_COMM_WORLD);
  }

  TEST(OutputDirectoryOnRanks, IsRefusedOnEveryRank)
  {
    const fs::path directory = fresh_directory("whipple_output_directory_ranks_");
    if (rank_of_this() == 0)
      {
        fs::create_directories(directory);
        std::ofstream(directory / "notes.txt") << "mine";
      }
    EXPECT_THROW(prepare_output_directory(directory.string(), EarlierRun::replaced, MPI_COMM_WORLD), InputError);
    EXPECT_NO_THROW(prepare_output_directory((directory / "run").string(), EarlierRun::replaced, MPI_COMM_WORLD));
    MPI_Barrier(MPI_COMM_WORLD);
  }
} // namespace
