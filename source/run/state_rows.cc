// SPDX-License-Identifier: LGPL-2.1-or-later
#include <whipple/error.h>
#include <whipple/mesh/gather.h>
#include <whipple/run/state_rows.h>

#include <algorithm>
#include <cstdint>

namespace whipple
{
  namespace
  {
    /// Numbers of a corner: position, velocity and mass of its node, its share of the cell's mass.
    template <int dim>
    constexpr int corner_columns = 2 * dim + 2;

    template <int dim>
    std::size_t
    n_columns(std::size_t cell_arrays)
    {
      return cell_arrays + static_cast<std::size_t>(FlatMesh<dim>::corners) * corner_columns<dim>;
    }

    /// Where each rank's rows begin among all.
    std::vector<std::uint64_t>
    first_rows(std::uint64_t own, MPI_Comm communicator)
    {
      const auto counts = gather_all<std::uint64_t>(communicator, std::span<const std::uint64_t>(&own, 1));
      std::vector<std::uint64_t> first{0};
      for (const std::uint64_t count : counts.entry)
        first.push_back(first.back() + count);
      return first;
    }
  } // namespace

  template <int dim>
  std::vector<std::string>
  row_columns(const FieldLayout &layout)
  {
    std::vector<std::string> names{"volume of the cell"};
    for (std::size_t m = 0; m < layout.materials.size(); ++m)
      {
        const std::string &material = layout.material_names[m];
        for (const char *what : {" volume", " mass", " density", " specific internal energy"})
          names.push_back(material + what);
        if (layout.materials[m].void_law)
          names.push_back(material + " void fraction");
        for (const FieldDescription &field : layout.fields)
          names.push_back(material + ' ' + field.name);
      }
    for (int k = 0; k < FlatMesh<dim>::corners; ++k)
      {
        const std::string corner = " of corner " + std::to_string(k);
        for (int d = 0; d < dim; ++d)
          names.push_back("position " + std::to_string(d) + corner);
        for (int d = 0; d < dim; ++d)
          names.push_back("velocity " + std::to_string(d) + corner);
        names.push_back("mass of the node" + corner);
        names.push_back("share of the mass" + corner);
      }
    return names;
  }

  template <int dim>
  StateRows
  to_rows(const FieldLayout &layout, const FlatMesh<dim> &mesh, const State<dim> &state)
  {
    const auto arrays = layout.cell_arrays(state);
    StateRows  rows;
    rows.columns = n_columns<dim>(arrays.size());
    rows.value.reserve(mesh.n_owned * rows.columns);
    for (Index c = 0; c < mesh.n_owned; ++c)
      {
        for (const std::vector<double> *array : arrays)
          rows.value.push_back((*array)[c]);
        for (int k = 0; k < FlatMesh<dim>::corners; ++k)
          {
            const Index corner = c * FlatMesh<dim>::corners + k, node = mesh.cell_node[corner];
            for (int d = 0; d < dim; ++d)
              rows.value.push_back(state.position[d][node]);
            for (int d = 0; d < dim; ++d)
              rows.value.push_back(state.velocity[d][node]);
            rows.value.push_back(state.node_mass[node]);
            rows.value.push_back(state.corner_weight[corner]);
          }
      }
    return rows;
  }

  template <int dim>
  void
  from_rows(const FieldLayout &layout, const StateRows &rows, double time, Domain<dim> &domain)
  {
    const FlatMesh<dim> &mesh   = domain.view->mesh;
    State<dim>           state  = layout.allocate(mesh);
    const auto           arrays = layout.cell_arrays(state);
    if (rows.columns != n_columns<dim>(arrays.size()) || rows.value.size() != mesh.n_owned * rows.columns)
      throw StateError(std::to_string(rows.value.size()) + " numbers for " + std::to_string(mesh.n_owned) +
                       " cells of " + std::to_string(n_columns<dim>(arrays.size())) + " numbers each");
    state.time          = time;
    const double *value = rows.value.data();
    for (Index c = 0; c < mesh.n_owned; ++c)
      {
        for (std::vector<double> *array : arrays)
          (*array)[c] = *value++;
        for (int k = 0; k < FlatMesh<dim>::corners; ++k)
          {
            const Index corner = c * FlatMesh<dim>::corners + k, node = mesh.cell_node[corner];
            for (int d = 0; d < dim; ++d)
              state.position[d][node] = *value++;
            for (int d = 0; d < dim; ++d)
              state.velocity[d][node] = *value++;
            state.node_mass[node]       = *value++;
            state.corner_weight[corner] = *value++;
          }
      }
    std::vector<std::vector<double> *> nodes{&state.node_mass};
    for (int d = 0; d < dim; ++d)
      {
        nodes.push_back(&state.position[d]);
        nodes.push_back(&state.velocity[d]);
      }
    domain.view->halo.exchange(arrays, nodes);
    domain.view->halo.exchange_corners(std::vector<std::vector<double> *>{&state.corner_weight});
    domain.state = std::move(state);
  }

  StateRows
  redistribute(const StateRows &rows, std::size_t wanted, MPI_Comm communicator)
  {
    int rank = 0, ranks = 1;
    MPI_Comm_rank(communicator, &rank);
    MPI_Comm_size(communicator, &ranks);
    StateRows result;
    result.columns = rows.columns; // every rank knows it, with or without rows
    result.value.resize(wanted * rows.columns);
    const std::vector<std::uint64_t> old_first = first_rows(rows.size(), communicator),
                                     new_first = first_rows(wanted, communicator);

    // the rows that each rank has of what another wants are one stretch
    const auto shared = [](const std::vector<std::uint64_t> &a, int i, const std::vector<std::uint64_t> &b, int j) {
      const std::uint64_t begin = std::max(a[i], b[j]), end = std::min(a[i + 1], b[j + 1]);
      return end > begin ? static_cast<int>(end - begin) : 0;
    };
    std::vector<int> send(ranks), send_first(ranks + 1, 0), receive(ranks), receive_first(ranks + 1, 0);
    for (int r = 0; r < ranks; ++r)
      {
        send[r]              = shared(old_first, rank, new_first, r);
        receive[r]           = shared(new_first, rank, old_first, r);
        send_first[r + 1]    = send_first[r] + send[r];
        receive_first[r + 1] = receive_first[r] + receive[r];
      }
    MPI_Datatype row;
    MPI_Type_contiguous(static_cast<int>(rows.columns), MPI_DOUBLE, &row);
    MPI_Type_commit(&row);
    MPI_Alltoallv(rows.value.data(), send.data(), send_first.data(), row, result.value.data(), receive.data(),
                  receive_first.data(), row, communicator);
    MPI_Type_free(&row);
    return result;
  }

  template std::vector<std::string>
  row_columns<2>(const FieldLayout &);
  template StateRows
  to_rows(const FieldLayout &, const FlatMesh<2> &, const State<2> &);
  template void
  from_rows(const FieldLayout &, const StateRows &, double, Domain<2> &);
} // namespace whipple
