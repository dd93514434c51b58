// SPDX-License-Identifier: LGPL-2.1-or-later
#include <whipple/projection/element.h>

#include <algorithm>
#include <bit>

namespace whipple
{
  namespace
  {
    /// Doubles an element travels as: key (its bits), positions, corner masses, packet.
    template <int dim>
    int
    record_size(const CellPacketLayout<dim> &layout)
    {
      return 1 + (dim + 1) * Element<dim>::corners + layout.size();
    }

    template <int dim>
    void
    write_record(const Element<dim> &element, std::vector<double> &buffer)
    {
      buffer.push_back(std::bit_cast<double>(element.key));
      for (const auto &axis : element.position)
        buffer.insert(buffer.end(), axis.begin(), axis.end());
      buffer.insert(buffer.end(), element.corner_mass.begin(), element.corner_mass.end());
      buffer.insert(buffer.end(), element.packet.begin(), element.packet.end());
    }

    template <int dim>
    Element<dim>
    read_record(const double *record, const double *end)
    {
      Element<dim> element;
      element.key = std::bit_cast<CellKey>(*record++);
      for (auto &axis : element.position)
        {
          std::copy_n(record, axis.size(), axis.begin());
          record += axis.size();
        }
      std::copy_n(record, element.corner_mass.size(), element.corner_mass.begin());
      element.packet.assign(record + element.corner_mass.size(), end);
      return element;
    }
  } // namespace

  template <int dim>
  std::vector<Element<dim>>
  elements_of(const CellPacketLayout<dim> &layout, const FlatMesh<dim> &mesh, const State<dim> &state)
  {
    constexpr int               corners    = 1 << dim;
    const CornerVelocities<dim> velocities = corner_velocities<dim>(mesh, state);
    InterfaceNormals<dim>       normals(layout.n_materials());
    for (auto &material : normals)
      for (auto &component : material)
        component.assign(mesh.n_owned, 0.);

    std::vector<Element<dim>> elements;
    for (Index cell = 0; cell < mesh.n_owned; ++cell)
      {
        Element<dim> element;
        element.packet = pack<dim>(layout, state, cell, velocities, normals);
        if (element.packet.empty())
          continue;
        element.key        = mesh.key[cell];
        const auto   share = corner_shares<dim>(state, cell);
        const double mass  = cell_mass<dim>(state, cell);
        for (int k = 0; k < corners; ++k)
          {
            element.corner_mass[k] = share[k] * mass;
            for (int d = 0; d < dim; ++d)
              element.position[d][k] = state.position[d][mesh.cell_node[cell * corners + k]];
          }
        elements.push_back(std::move(element));
      }
    return elements;
  }

  template <int dim>
  std::vector<Element<dim>>
  gather_elements(MPI_Comm communicator, const CellPacketLayout<dim> &layout, const std::vector<Element<dim>> &mine)
  {
    const int           record = record_size(layout);
    std::vector<double> send;
    send.reserve(mine.size() * record);
    for (const Element<dim> &element : mine)
      write_record(element, send);

    int ranks = 1;
    MPI_Comm_size(communicator, &ranks);
    // counted in records, so that the counts stay within an int
    MPI_Datatype type;
    MPI_Type_contiguous(record, MPI_DOUBLE, &type);
    MPI_Type_commit(&type);
    const int        count = static_cast<int>(mine.size());
    std::vector<int> counts(ranks), offsets(ranks, 0);
    MPI_Allgather(&count, 1, MPI_INT, counts.data(), 1, MPI_INT, communicator);
    for (int rank = 1; rank < ranks; ++rank)
      offsets[rank] = offsets[rank - 1] + counts[rank - 1];
    const std::size_t   total = offsets.back() + counts.back();
    std::vector<double> all(total * record);
    MPI_Allgatherv(send.data(), count, type, all.data(), counts.data(), offsets.data(), type, communicator);
    MPI_Type_free(&type);

    std::vector<Element<dim>> elements;
    elements.reserve(total);
    for (std::size_t i = 0; i < total; ++i)
      elements.push_back(read_record<dim>(all.data() + i * record, all.data() + (i + 1) * record));
    std::sort(elements.begin(), elements.end(), [](const auto &a, const auto &b) { return a.key < b.key; });
    return elements;
  }

  template <int dim>
  ConservedTotals<dim>
  totals_of(const CellPacketLayout<dim> &layout, const Element<dim> &element)
  {
    ConservedTotals<dim> totals;
    for (int m = 0; m < layout.n_materials(); ++m)
      {
        totals.mass += element.packet[layout.mass(m)];
        totals.internal_energy += element.packet[layout.mass(m)] * element.packet[layout.energy(m)];
      }
    totals.kinetic_energy = element.packet[layout.kinetic_remainder()];
    for (int k = 0; k < Element<dim>::corners; ++k)
      for (int d = 0; d < dim; ++d)
        {
          const double u = element.packet[layout.velocity(d, k)];
          totals.momentum[d] += element.corner_mass[k] * u;
          totals.kinetic_energy += 0.5 * element.corner_mass[k] * u * u;
        }
    return totals;
  }

  template std::vector<Element<2>>
  elements_of<2>(const CellPacketLayout<2> &, const FlatMesh<2> &, const State<2> &);
  template std::vector<Element<2>>
  gather_elements<2>(MPI_Comm, const CellPacketLayout<2> &, const std::vector<Element<2>> &);
  template ConservedTotals<2>
  totals_of<2>(const CellPacketLayout<2> &, const Element<2> &);
} // namespace whipple
