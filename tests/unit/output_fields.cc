// SPDX-License-Identifier: LGPL-2.1-or-later
#include <deal.II/base/hdf5.h>
#include <deal.II/lac/full_matrix.h>

#include <whipple/mesh/flat_builder.h>
#include <whipple/output/field_output.h>
#include <whipple/output/snapshot.h>
#include <whipple/output/version.h>

#include <gtest/gtest.h>

#include <filesystem>
#include <fstream>
#include <regex>
#include <sstream>
#include <string>

namespace
{
  using namespace whipple;
  namespace fs = std::filesystem;

  /// Root cells (0,0) and (1,0) of 1 cm; the right one refined once: five cells and a hanging node.
  FlatMesh<2>
  small_mesh()
  {
    Lattice<2> lattice;
    lattice.spacing   = 0.5;
    lattice.roots     = {{2, 1}};
    lattice.max_level = 1;
    const std::vector<CellKey> keys{make_key<2>(0, {{0, 0}}), make_key<2>(1, {{2, 0}}), make_key<2>(1, {{3, 0}}),
                                    make_key<2>(1, {{2, 1}}), make_key<2>(1, {{3, 1}})};
    return build_flat_mesh<2>(lattice, keys, 5, std::vector<std::uint8_t>(5, 0), 0, Cohesion::bonded);
  }

  MaterialState
  material_of(const State<2> &state, double fraction, double density)
  {
    MaterialState     m;
    const std::size_t n = state.volume.size();
    for (const double v : state.volume)
      {
        m.volume.push_back(fraction * v);
        m.mass.push_back(density * fraction * v);
      }
    m.density.assign(n, density);
    m.energy.assign(n, 1e-3);
    Field strain;
    strain.description.name = "plastic strain";
    strain.description.unit = "1";
    strain.value.assign(n, 0.25);
    m.fields.push_back(strain);
    return m;
  }

  /// What the models of both materials would say.
  Derived
  half_a_megabar(const State<2> &state)
  {
    Derived derived;
    for (std::size_t m = 0; m < state.material.size(); ++m)
      derived.material.emplace_back().pressure.assign(state.volume.size(), 0.5);
    return derived;
  }

  /// Two materials; the first fills half of every cell and is half void, the second a quarter; cell 2 is empty.
  State<2>
  small_state(const FlatMesh<2> &mesh)
  {
    State<2> state;
    state.time     = 1.25;
    state.position = mesh.node_point;
    for (double &y : state.position[1])
      y *= 1.1; // deformed
    state.velocity[0].assign(mesh.n_nodes, 0.);
    state.velocity[1].assign(mesh.n_nodes, -0.658);
    state.node_mass.assign(mesh.n_nodes, 1.);
    for (const double h : mesh.size)
      state.volume.push_back(1.1 * h * h);
    state.material.push_back(material_of(state, 0.5, 1.4));
    state.material[0].void_fraction.assign(mesh.n_cells, 0.5);
    state.material.push_back(material_of(state, 0.25, 8.));
    for (MaterialState &m : state.material)
      m.volume[2] = m.mass[2] = 0;
    return state;
  }

  const std::vector<std::string> names{"aluminium 2024", "copper"};

  const CellField &
  field(const Snapshot<2> &snapshot, const std::string &name)
  {
    for (const CellField &f : snapshot.fields)
      if (f.name == name)
        return f;
    throw std::runtime_error("no field " + name);
  }

  std::string
  content(const fs::path &path)
  {
    std::ifstream      file(path);
    std::ostringstream text;
    text << file.rdbuf();
    return text.str();
  }

  /// Every data item of an .xdmf must exist in its file with the size it is announced with.
  int
  check_data_items(const fs::path &xdmf)
  {
    const std::string text = content(xdmf);
    const std::regex  item("<DataItem Dimensions=\"([0-9 ]+)\"[^>]*>([^:<]+):/([^<]+)</DataItem>");
    int               count = 0;
    for (std::sregex_iterator i(text.begin(), text.end(), item), end; i != end; ++i, ++count)
      {
        dealii::HDF5::File   file((xdmf.parent_path() / (*i)[2].str()).string(),
                                  dealii::HDF5::File::FileAccessMode::open);
        std::istringstream   announced((*i)[1].str());
        std::vector<hsize_t> dimensions;
        for (hsize_t n; announced >> n;)
          dimensions.push_back(n);
        EXPECT_EQ(file.open_dataset((*i)[3].str()).get_dimensions(), dimensions) << (*i)[3].str();
      }
    return count;
  }

  TEST(Snapshot, HoldsCellsWithMaterial)
  {
    const FlatMesh<2> mesh     = small_mesh();
    const State<2>    state    = small_state(mesh);
    const Snapshot<2> snapshot = take_snapshot<2>(mesh, state, half_a_megabar(state), names, {}, {});
    EXPECT_EQ(snapshot.n_cells(), 4u);
    // nine nodes carry the corners of the five cells in the mesh; all but one of cell 2's corners are shared
    EXPECT_EQ(snapshot.n_nodes(), static_cast<std::size_t>(mesh.n_nodes) - 1);
    EXPECT_DOUBLE_EQ(field(snapshot, "density").value[0], 0.5 * 1.4 + 0.25 * 8.);
    EXPECT_DOUBLE_EQ(field(snapshot, "pressure").value[1], 0.75 * 0.5);
    EXPECT_DOUBLE_EQ(field(snapshot, "solid fraction").value[2], 0.5 * 0.5 + 0.25);
    EXPECT_DOUBLE_EQ(field(snapshot, "aluminium 2024 true density").value[3], 2.8);
    EXPECT_DOUBLE_EQ(field(snapshot, "copper true density").value[3], 8.);
    EXPECT_DOUBLE_EQ(field(snapshot, "aluminium 2024 void fraction").value[0], 0.5);
    EXPECT_DOUBLE_EQ(field(snapshot, "copper plastic strain").value[0], 0.25);
    EXPECT_THROW(field(snapshot, "copper void fraction"), std::runtime_error);
    EXPECT_EQ(field(snapshot, "level").value, (std::vector<double>{0, 1, 1, 1}));
    for (const CellField &f : snapshot.fields)
      EXPECT_EQ(f.value.size(), 4u) << f.name;
    EXPECT_EQ(take_snapshot<2>(mesh, state, half_a_megabar(state), names, {}, {.empty_cells = true}).n_cells(), 5u);
  }

  TEST(FieldOutput, SeriesMatchesItsFiles)
  {
    const fs::path directory = fs::current_path() / "whipple field output test";
    fs::remove_all(directory);
    fs::create_directories(directory);
    const FlatMesh<2> mesh  = small_mesh();
    State<2>          state = small_state(mesh);
    {
      FieldOutput<2> output(directory.string(), names, {.vtu = true}, MPI_COMM_SELF);
      output.write(mesh, state, half_a_megabar(state), "perforation");
      output.write(mesh, state, half_a_megabar(state), "perforation"); // the same state: written once
      output.write(mesh, state, half_a_megabar(state), "debris <flight>");
      for (MaterialState &m : state.material)
        m.mass.assign(mesh.n_cells, 0.);
      output.write(mesh, state, half_a_megabar(state), "nothing left");
      EXPECT_EQ(output.count(), 2);
    }
    // per time: nodes, cells, velocity, 5 of the cell, 7 of the material with voids, 6 of the one without
    EXPECT_EQ(check_data_items(directory / "fields.xdmf"), 2 * (3 + 5 + 7 + 6));
    const std::string series = content(directory / "fields.xdmf");
    EXPECT_NE(series.find("<Time Value=\"1.25\"/>"), std::string::npos);
    // a hand-over has two states at one time; readers need two times
    EXPECT_NE(series.find("<Time Value=\"1.2500000012500001\"/>"), std::string::npos);
    const std::string record = content(directory / "fields.pvd");
    EXPECT_NE(record.find("timestep=\"1.25\""), std::string::npos) << record;
    EXPECT_NE(record.find("timestep=\"1.2500000012500001\""), std::string::npos) << record;
    EXPECT_NE(record.find("file=\"fields/fields-00001.vtu\""), std::string::npos) << record;
    for (const char *name : {"fields/fields-00001.h5", "fields/fields-00001.vtu"})
      EXPECT_NE(content(directory / "manifest.txt").find(name), std::string::npos);
    EXPECT_NE(series.find("Name=\"debris &lt;flight>\""), std::string::npos);
    EXPECT_NE(content(directory / "fields/fields-00001.vtu").find("density [g/cm^3]"), std::string::npos);

    dealii::HDF5::File file((directory / "fields/fields-00000.h5").string(), dealii::HDF5::File::FileAccessMode::open);
    EXPECT_EQ(file.get_attribute<double>("time"), 1.25);
    EXPECT_EQ(file.get_attribute<std::string>("stage"), "perforation");
    EXPECT_NE(file.get_attribute<std::string>("version").find(std::string(version::number())), std::string::npos);
    const auto cells   = file.open_dataset("cells").read<dealii::FullMatrix<double>>();
    const auto nodes   = file.open_dataset("nodes").read<dealii::FullMatrix<double>>();
    const auto density = file.open_dataset("aluminium_2024_density").read<std::vector<float>>();
    EXPECT_EQ(density, std::vector<float>(4, 1.4f));
    double area = 0; // counter-clockwise walks around deformed cells have these positive areas
    for (unsigned int c = 0; c < cells.m(); ++c)
      for (unsigned int k = 0; k < 4; ++k)
        {
          const auto a = static_cast<unsigned int>(cells(c, k)), b = static_cast<unsigned int>(cells(c, (k + 1) % 4));
          area += 0.5 * (nodes(a, 0) * nodes(b, 1) - nodes(b, 0) * nodes(a, 1));
        }
    EXPECT_NEAR(area, 1.1 * (1. + 0.75), 1e-14);
    fs::remove_all(directory);
  }

  TEST(FieldOutput, LastGoodStateIsComplete)
  {
    const fs::path directory = fs::current_path() / "whipple_last_good_state_test";
    fs::remove_all(directory);
    const FlatMesh<2> mesh  = small_mesh();
    const State<2>    state = small_state(mesh);
    write_last_good_state(directory.string(), mesh, state, half_a_megabar(state), names, "perforation",
                          "negative volume -1", MPI_COMM_SELF);
    const fs::path folder = directory / "last_good_state";
    EXPECT_NE(content(folder / "README.txt").find("negative volume -1"), std::string::npos);
    EXPECT_EQ(check_data_items(folder / "rank-00000.xdmf"), 3 + 5 + 7 + 6 + 3 + 4);
    dealii::HDF5::File file((folder / "rank-00000.h5").string(), dealii::HDF5::File::FileAccessMode::open);
    EXPECT_EQ(file.open_dataset("copper_mass").read<std::vector<double>>(), state.material[1].mass);
    EXPECT_EQ(file.open_dataset("lattice_point_0").read<std::vector<double>>(), (std::vector<double>{0, 2, 3, 2, 3}));
    fs::remove_all(directory);
  }
} // namespace
