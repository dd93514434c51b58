// SPDX-License-Identifier: LGPL-2.1-or-later
#include <whipple/error.h>
#include <whipple/output/checksum.h>
#include <whipple/output/disk_room.h>
#include <whipple/output/first_rank.h>
#include <whipple/output/hdf5_table.h>

#include "checkpoint_file.h"

#include <cstdint>

namespace whipple::checkpoint_file
{
  namespace
  {
    namespace HDF5 = dealii::HDF5;

    /// A table of `width` columns, every rank its rows, with the checksum of the whole.
    /// @returns that checksum
    template <typename Number>
    std::string
    write_table(const HDF5::Group &file, const std::string &name, const std::vector<Number> &values, std::size_t width,
                MPI_Comm communicator)
    {
      HDF5::DataSet table =
          hdf5_table::write(file, name, values, hdf5_table::rows_of(values.size() / width, communicator), width);
      const std::string sum =
          checksum::text(checksum::of_all_ranks(std::as_bytes(std::span<const Number>(values)), communicator));
      table.set_attribute("crc32", sum);
      return sum;
    }

    /// This rank's rows of such a table.
    /// @throws StateError on all ranks if the sum of all is wrong
    template <typename Number>
    std::vector<Number>
    read_table(const HDF5::Group &file, const std::string &name, std::size_t count, MPI_Comm communicator)
    {
      HDF5::DataSet table = file.open_dataset(name);
      const auto    size  = table.get_dimensions();
      const auto    rows  = hdf5_table::rows_of(count, communicator);
      if (size.size() != 2 || rows.global != size[0])
        throw StateError("dataset " + name + " has not " + std::to_string(rows.global) + " rows");
      std::vector<Number> values;
      if (rows.local > 0)
        values = table.template read_hyperslab<std::vector<Number>>({rows.offset, 0}, {rows.local, size[1]});
      else if (rows.global > 0)
        table.template read_none<Number>();
      const std::string sum =
          checksum::text(checksum::of_all_ranks(std::as_bytes(std::span<const Number>(values)), communicator));
      if (sum != table.get_attribute<std::string>("crc32"))
        throw StateError("dataset " + name + " has checksum " + sum + ", written was " +
                         table.get_attribute<std::string>("crc32"));
      return values;
    }

    /// What the first rank read, on all.
    template <typename Number>
    void
    broadcast(std::vector<Number> &values, MPI_Comm communicator)
    {
      std::uint64_t size = values.size();
      MPI_Bcast(&size, 1, MPI_UINT64_T, 0, communicator);
      values.resize(size);
      MPI_Bcast(values.data(), static_cast<int>(size * sizeof(Number)), MPI_BYTE, 0, communicator);
    }

    std::string
    joined(const std::vector<std::string> &columns)
    {
      std::string text;
      for (const std::string &column : columns)
        text += (text.empty() ? "" : "; ") + column;
      return text;
    }

    // a leaf is four words: both halves of its key, whether it is active, whether it is intact
    constexpr std::size_t words_of_leaf = 4;
  } // namespace

  Checksums
  write(const std::string &path, const MeshImage &mesh, const std::vector<std::string> &columns, const StateRows &rows,
        double time, MPI_Comm communicator)
  {
    std::vector<unsigned int> leaves;
    if (is_first_rank(communicator))
      for (std::size_t i = 0; i < mesh.leaf.size(); ++i)
        for (const std::uint64_t word : {mesh.leaf[i] >> 32, mesh.leaf[i] & 0xffffffffu, std::uint64_t(mesh.active[i]),
                                         std::uint64_t(mesh.intact[i])})
          leaves.push_back(static_cast<unsigned int>(word));
    require_disk_room(path, sizeof(unsigned int) * leaves.size() + sizeof(double) * rows.value.size(), communicator);
    HDF5::File file(path, HDF5::File::FileAccessMode::create, communicator);
    file.set_attribute("columns", joined(columns));
    file.set_attribute("time [us]", time);
    file.set_attribute("halo width", mesh.halo_width);
    const std::string leaves_sum = write_table(file, "leaves", leaves, words_of_leaf, communicator);
    return {{"leaves", leaves_sum}, {"cells", write_table(file, "cells", rows.value, rows.columns, communicator)}};
  }

  MeshImage
  read_mesh(const std::string &path, MPI_Comm communicator)
  {
    HDF5::File file(path, HDF5::File::FileAccessMode::open, communicator);
    const auto n      = file.open_dataset("leaves").get_dimensions().at(0);
    auto       leaves = read_table<unsigned int>(file, "leaves", is_first_rank(communicator) ? n : 0, communicator);
    broadcast(leaves, communicator);
    MeshImage mesh;
    mesh.halo_width = file.get_attribute<int>("halo width");
    for (std::size_t i = 0; i < leaves.size(); i += words_of_leaf)
      {
        mesh.leaf.push_back(std::uint64_t(leaves[i]) << 32 | leaves[i + 1]);
        mesh.active.push_back(static_cast<std::uint8_t>(leaves[i + 2]));
        mesh.intact.push_back(static_cast<std::uint8_t>(leaves[i + 3]));
      }
    return mesh;
  }

  Fields
  read_rows(const std::string &path, const std::vector<std::string> &columns, std::size_t count, MPI_Comm communicator)
  {
    HDF5::File file(path, HDF5::File::FileAccessMode::open, communicator);
    if (file.get_attribute<std::string>("columns") != joined(columns))
      throw StateError("its fields are those of other effects or materials");
    Fields fields;
    fields.time         = file.get_attribute<double>("time [us]");
    fields.rows.columns = columns.size();
    fields.rows.value   = read_table<double>(file, "cells", count, communicator);
    return fields;
  }
} // namespace whipple::checkpoint_file
