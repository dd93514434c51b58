// SPDX-License-Identifier: LGPL-2.1-or-later
#include <whipple/mesh/halo.h>

namespace whipple
{
  namespace
  {
    constexpr int message_tag = 1;

    /// Values that one exchange moves per cell.
    template <int dim>
    struct Arrays
    {
      std::span<std::vector<double> *const> cell, node, corner;

      std::size_t
      values_per_cell() const
      {
        return cell.size() + FlatMesh<dim>::corners * (node.size() + corner.size());
      }
    };

    /// Applies copy(entry of the array, entry of the message) array by array, cell by cell: the order both
    /// sides of a message agree on.
    template <int dim, class Copy>
    void
    for_each_value(const FlatMesh<dim> &mesh, const std::vector<Index> &cells, const Arrays<dim> &arrays,
                   double *message, const Copy &copy)
    {
      constexpr int corners = FlatMesh<dim>::corners;
      for (std::vector<double> *array : arrays.cell)
        for (const Index cell : cells)
          copy((*array)[cell], *message++);
      for (std::vector<double> *array : arrays.node)
        for (const Index cell : cells)
          for (int k = 0; k < corners; ++k)
            copy((*array)[mesh.cell_node[cell * corners + k]], *message++);
      for (std::vector<double> *array : arrays.corner)
        for (const Index cell : cells)
          for (int k = 0; k < corners; ++k)
            copy((*array)[cell * corners + k], *message++);
    }
  } // namespace

  template <int dim>
  Halo<dim>::Halo(MPI_Comm communicator, const FlatMesh<dim> &mesh, std::vector<Neighbour> neighbours)
    : communicator_(communicator)
    , mesh_(&mesh)
    , neighbours_(std::move(neighbours))
    , buffers_(neighbours_.size())
    , requests_(2 * neighbours_.size(), MPI_REQUEST_NULL)
  {
  }

  template <int dim>
  void
  Halo<dim>::exchange(std::span<std::vector<double> *const> cell_arrays,
                      std::span<std::vector<double> *const> node_arrays) const
  {
    exchange_all(cell_arrays, node_arrays, {});
  }

  template <int dim>
  void
  Halo<dim>::exchange_corners(std::span<std::vector<double> *const> corner_arrays) const
  {
    exchange_all({}, {}, corner_arrays);
  }

  template <int dim>
  void
  Halo<dim>::exchange_all(std::span<std::vector<double> *const> cell_arrays,
                          std::span<std::vector<double> *const> node_arrays,
                          std::span<std::vector<double> *const> corner_arrays) const
  {
    const Arrays<dim> arrays{cell_arrays, node_arrays, corner_arrays};
    const std::size_t width = arrays.values_per_cell();
    const int         n     = static_cast<int>(neighbours_.size());
    if (n == 0 || width == 0)
      return;

    for (int i = 0; i < n; ++i)
      {
        std::vector<double> &buffer = buffers_[i].receive;
        buffer.resize(neighbours_[i].receive.size() * width); // allocates only when larger than ever before
        if (!buffer.empty())
          MPI_Irecv(buffer.data(), static_cast<int>(buffer.size()), MPI_DOUBLE, neighbours_[i].rank, message_tag,
                    communicator_, &requests_[i]);
      }
    for (int i = 0; i < n; ++i)
      {
        std::vector<double> &buffer = buffers_[i].send;
        buffer.resize(neighbours_[i].send.size() * width);
        for_each_value(*mesh_, neighbours_[i].send, arrays, buffer.data(),
                       [](const double &value, double &message) { message = value; });
        if (!buffer.empty())
          MPI_Isend(buffer.data(), static_cast<int>(buffer.size()), MPI_DOUBLE, neighbours_[i].rank, message_tag,
                    communicator_, &requests_[n + i]);
      }
    MPI_Waitall(2 * n, requests_.data(), MPI_STATUSES_IGNORE);
    for (int i = 0; i < n; ++i)
      for_each_value(*mesh_, neighbours_[i].receive, arrays, buffers_[i].receive.data(),
                     [](double &value, const double &message) { value = message; });
  }

  template class Halo<2>;
} // namespace whipple
