// SPDX-License-Identifier: LGPL-2.1-or-later
#include <whipple/output/disk_room.h>
#include <whipple/output/hdf5_table.h>
#include <whipple/output/snapshot_hdf5.h>
#include <whipple/output/version.h>
#include <whipple/output/xml.h>

#include <array>
#include <cctype>
#include <cstdint>
#include <filesystem>
#include <fstream>
#include <limits>
#include <set>
#include <sstream>
#include <stdexcept>

namespace whipple::snapshot_hdf5
{
  namespace
  {
    namespace HDF5 = dealii::HDF5;
    using hdf5_table::Rows;
    using hdf5_table::rows_of;

    /// A name that is legal in HDF5 paths and XDMF references, and not taken yet.
    std::string
    dataset_name(const std::string &field, std::set<std::string> &taken)
    {
      std::string name;
      for (const char c : field)
        name += std::isalnum(static_cast<unsigned char>(c)) ? c : '_';
      std::string unique = name;
      for (int copy = 2; !taken.insert(unique).second; ++copy)
        unique = name + '_' + std::to_string(copy);
      return unique;
    }

    std::string
    data_item(const std::string &stored_path, const std::string &dataset, const std::string &dimensions,
              std::string_view number_type, int bytes)
    {
      std::ostringstream text;
      text << "<DataItem Dimensions=\"" << dimensions << "\" NumberType=\"" << number_type << "\" Precision=\"" << bytes
           << "\" Format=\"HDF\">" << xml(stored_path) << ":/" << dataset << "</DataItem>";
      return text.str();
    }

    template <int dim>
    std::string
    grid_head(const GridPlace &place, const Rows &nodes, const Rows &cells)
    {
      constexpr bool     plane   = dim == 2;
      const std::string  n_cells = std::to_string(cells.global), n_nodes = std::to_string(nodes.global);
      std::ostringstream text;
      text.precision(std::numeric_limits<double>::max_digits10);
      text << "<Grid Name=\"" << xml(place.stage) << "\" GridType=\"Uniform\">\n<Time Value=\"" << place.shown_time
           << "\"/>\n<Geometry GeometryType=\"" << (plane ? "XY" : "XYZ") << "\">"
           << data_item(place.path, "nodes", n_nodes + ' ' + std::to_string(dim), "Float", 8)
           << "</Geometry>\n<Topology TopologyType=\"" << (plane ? "Quadrilateral" : "Hexahedron")
           << "\" NumberOfElements=\"" << n_cells << "\">"
           << data_item(place.path, "cells", n_cells + ' ' + std::to_string(1 << dim), "Int", 4) << "</Topology>\n";
      return text.str();
    }

    std::string
    attribute(const std::string &name, const std::string &unit, std::string_view type, std::string_view center,
              const std::string &item)
    {
      std::ostringstream text;
      text << "<Attribute Name=\"" << xml(with_unit(name, unit)) << "\" AttributeType=\"" << type << "\" Center=\""
           << center << "\">" << item << "</Attribute>\n";
      return text.str();
    }

    /// What a file is, for those who find it alone.
    void
    describe(HDF5::File &file, double time, const std::string &stage)
    {
      file.set_attribute("time", time);
      file.set_attribute("stage", stage);
      file.set_attribute("units",
                         std::string("cm, g, us, Mbar, K; 1 for pure numbers; attribute 'unit' of each dataset"));
      file.set_attribute("version",
                         "Whipple " + std::string(version::number()) + " (" + std::string(version::git_hash()) + ')');
    }

    template <typename Number, int dim>
    std::string
    write_as(const Snapshot<dim> &snapshot, const std::string &path, const GridPlace &place, MPI_Comm communicator)
    {
      const Rows nodes = rows_of(snapshot.n_nodes(), communicator), cells = rows_of(snapshot.n_cells(), communicator);
      const auto stored = [](const std::vector<double> &values) {
        return std::vector<Number>(values.begin(), values.end());
      };
      constexpr int bytes = sizeof(Number);
      require_disk_room(path,
                        sizeof(double) * snapshot.position.size() + bytes * snapshot.velocity.size() +
                            sizeof(std::uint64_t) * snapshot.cell_node.size() +
                            bytes * snapshot.fields.size() * snapshot.n_cells(),
                        communicator);

      HDF5::File file(path, HDF5::File::FileAccessMode::create, communicator);
      describe(file, snapshot.time, place.stage);
      std::string grid = grid_head<dim>(place, nodes, cells);
      hdf5_table::write(file, "nodes", snapshot.position, nodes, dim).set_attribute("unit", std::string("cm"));
      hdf5_table::write(file, "cells", walked_cells(snapshot, nodes.offset), cells, Snapshot<dim>::corners);
      hdf5_table::write(file, "velocity", stored(snapshot.velocity), nodes, 3)
          .set_attribute("unit", std::string("cm/us"));
      grid += attribute("velocity", "cm/us", "Vector", "Node",
                        data_item(place.path, "velocity", std::to_string(nodes.global) + " 3", "Float", bytes));
      std::set<std::string> taken{"nodes", "cells", "velocity"};
      for (const CellField &field : snapshot.fields)
        {
          const std::string name = dataset_name(field.name, taken);
          hdf5_table::write(file, name, stored(field.value), cells, 1).set_attribute("unit", field.unit);
          grid += attribute(field.name, field.unit, "Scalar", "Cell",
                            data_item(place.path, name, std::to_string(cells.global), "Float", bytes));
        }
      return grid + "</Grid>\n";
    }
  } // namespace

  template <int dim>
  std::string
  write(const Snapshot<dim> &snapshot, const std::string &path, const GridPlace &place, Precision precision,
        MPI_Comm communicator)
  {
    if (precision == Precision::single_precision)
      return write_as<float>(snapshot, path, place, communicator);
    return write_as<double>(snapshot, path, place, communicator);
  }

  void
  write_series(const std::string &path, std::span<const std::string> grids)
  {
    const std::string temporary = path + ".part";
    {
      std::ofstream file(temporary);
      file << "<?xml version=\"1.0\"?>\n<Xdmf Version=\"3.0\">\n<Domain>\n"
              "<Grid Name=\"Whipple\" GridType=\"Collection\" CollectionType=\"Temporal\">\n";
      for (const std::string &grid : grids)
        file << grid;
      file << "</Grid>\n</Domain>\n</Xdmf>\n" << std::flush;
      if (!file)
        throw std::runtime_error(temporary + ": cannot be written");
    }
    std::filesystem::rename(temporary, path);
  }

  template std::string
  write<2>(const Snapshot<2> &, const std::string &, const GridPlace &, Precision, MPI_Comm);
} // namespace whipple::snapshot_hdf5
