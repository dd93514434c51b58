// SPDX-License-Identifier: LGPL-2.1-or-later
#include <deal.II/base/utilities.h>

#include <whipple/error.h>
#include <whipple/output/disk_room.h>
#include <whipple/output/snapshot_vtu.h>
#include <whipple/output/xml.h>

#include <cstdint>
#include <cstring>
#include <sstream>
#include <type_traits>

namespace whipple::snapshot_vtu
{
  namespace
  {
    /// The names that VTK gives to types.
    template <typename Number>
    constexpr const char *type_name = std::is_same_v<Number, double>         ? "Float64"
                                      : std::is_same_v<Number, float>        ? "Float32"
                                      : std::is_same_v<Number, std::int32_t> ? "Int32"
                                                                             : "UInt8";

    /// Length in bytes, then the values, in base 64.
    template <typename Number>
    void
    write_array(std::ostream &text, const std::string &name, std::size_t components, const std::vector<Number> &values)
    {
      const std::uint64_t        length = values.size() * sizeof(Number);
      std::vector<unsigned char> bytes(sizeof length + length);
      std::memcpy(bytes.data(), &length, sizeof length);
      if (length > 0)
        std::memcpy(bytes.data() + sizeof length, values.data(), length);
      text << "<DataArray type=\"" << type_name<Number> << "\" Name=\"" << name << "\" NumberOfComponents=\""
           << components << "\" format=\"binary\">" << dealii::Utilities::encode_base64(bytes) << "</DataArray>\n";
    }

    std::vector<float>
    single_precision(const std::vector<double> &values)
    {
      return {values.begin(), values.end()};
    }

    /// Places of the nodes, in three dimensions as VTK wants them.
    template <int dim>
    std::vector<double>
    points(const Snapshot<dim> &snapshot)
    {
      std::vector<double> points(3 * snapshot.n_nodes(), 0.);
      for (std::size_t n = 0; n < snapshot.n_nodes(); ++n)
        for (int d = 0; d < dim; ++d)
          points[3 * n + d] = snapshot.position[n * dim + d];
      return points;
    }

    /// VTK's quadrilateral and hexahedron.
    template <int dim>
    constexpr std::uint8_t cell_type = dim == 2 ? 9 : 12;

    template <int dim>
    std::string
    piece(const Snapshot<dim> &snapshot)
    {
      constexpr int      corners = Snapshot<dim>::corners;
      std::ostringstream text;
      text << "<Piece NumberOfPoints=\"" << snapshot.n_nodes() << "\" NumberOfCells=\"" << snapshot.n_cells()
           << "\">\n<PointData>\n";
      write_array(text, "velocity [cm/us]", 3, single_precision(snapshot.velocity));
      text << "</PointData>\n<CellData>\n";
      for (const CellField &field : snapshot.fields)
        write_array(text, xml(with_unit(field.name, field.unit)), 1, single_precision(field.value));
      text << "</CellData>\n<Points>\n";
      write_array(text, "Points", 3, points(snapshot));
      text << "</Points>\n<Cells>\n";
      write_array(text, "connectivity", 1, walked_cells(snapshot, 0));
      std::vector<std::int32_t> ends(snapshot.n_cells());
      for (std::size_t c = 0; c < ends.size(); ++c)
        ends[c] = static_cast<std::int32_t>((c + 1) * corners);
      write_array(text, "offsets", 1, ends);
      write_array(text, "types", 1, std::vector<std::uint8_t>(snapshot.n_cells(), cell_type<dim>));
      text << "</Cells>\n</Piece>\n";
      return text.str();
    }

    std::string
    head(double time)
    {
      std::ostringstream text;
      text << "<?xml version=\"1.0\"?>\n<VTKFile type=\"UnstructuredGrid\" version=\"1.0\" byte_order=\"LittleEndian\" "
              "header_type=\"UInt64\">\n<UnstructuredGrid>\n<FieldData>\n";
      write_array(text, "TimeValue", 1, std::vector<double>{time});
      text << "</FieldData>\n";
      return text.str();
    }

    /// The texts of all ranks, one after the other. @throws Error
    void
    write_in_order(const std::string &path, const std::string &text, MPI_Comm communicator)
    {
      require_disk_room(path, text.size(), communicator);
      MPI_File  file;
      const int mode = MPI_MODE_CREATE | MPI_MODE_WRONLY;
      int       failed =
          MPI_File_open(communicator, path.c_str(), mode, MPI_INFO_NULL, &file) != MPI_SUCCESS; // returns, as files do
      if (!failed)
        {
          failed |= MPI_File_set_size(file, 0) != MPI_SUCCESS;
          failed |= MPI_File_write_ordered(file, text.data(), static_cast<int>(text.size()), MPI_CHAR,
                                           MPI_STATUS_IGNORE) != MPI_SUCCESS;
          failed |= MPI_File_close(&file) != MPI_SUCCESS;
        }
      MPI_Allreduce(MPI_IN_PLACE, &failed, 1, MPI_INT, MPI_LOR, communicator);
      if (failed)
        throw Error(path + ": cannot be written");
    }
  } // namespace

  template <int dim>
  void
  write(const Snapshot<dim> &snapshot, const std::string &path, MPI_Comm communicator)
  {
    int rank = 0, ranks = 1;
    MPI_Comm_rank(communicator, &rank);
    MPI_Comm_size(communicator, &ranks);
    std::string text = rank == 0 ? head(snapshot.time) : std::string{};
    if (snapshot.n_cells() > 0)
      text += piece(snapshot);
    if (rank + 1 == ranks)
      text += "</UnstructuredGrid>\n</VTKFile>\n";
    write_in_order(path, text, communicator);
  }

  template void
  write<2>(const Snapshot<2> &, const std::string &, MPI_Comm);
} // namespace whipple::snapshot_vtu
