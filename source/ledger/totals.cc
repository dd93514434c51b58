// SPDX-License-Identifier: LGPL-2.1-or-later
#include <whipple/ledger/exact_totals.h>
#include <whipple/ledger/totals.h>
#include <whipple/projection/cell_totals.h>

namespace whipple
{
  namespace
  {
    template <int dim>
    Vector<dim>
    node_velocity(const State<dim> &state, Index n)
    {
      Vector<dim> v;
      for (int d = 0; d < dim; ++d)
        v[d] = state.velocity[d][n];
      return v;
    }

    template <int dim>
    Vector<dim>
    corner_velocity(const CellPacketLayout<dim> &layout, const CellPacket &packet, int corner)
    {
      Vector<dim> v;
      for (int d = 0; d < dim; ++d)
        v[d] = packet[layout.velocity(d, corner)];
      return v;
    }

    /// The part of each body in the mass of one material: what its tag says, or what the other tags leave.
    template <typename Value>
    void
    body_shares(const std::vector<int> &tag, const std::vector<Index> &material, Index m, std::vector<double> &share,
                const Value &value_of_field)
    {
      double rest = 1.;
      for (std::size_t b = 0; b < tag.size(); ++b)
        {
          share[b] = tag[b] >= 0 && material[b] == m ? value_of_field(tag[b]) : 0.;
          rest -= share[b];
        }
      for (std::size_t b = 0; b < tag.size(); ++b)
        if (tag[b] < 0 && material[b] == m)
          share[b] = rest;
    }
  } // namespace

  template <int dim>
  ConservedTotals<dim>
  totals(const FlatMesh<dim> &mesh, const State<dim> &state, MPI_Comm communicator)
  {
    ExactTotals<dim> sums;
    for (const MaterialState &m : state.material)
      for (Index c = 0; c < mesh.n_owned; ++c)
        if (m.mass[c] != 0.)
          {
            sums.sum[0].add(m.mass[c]);
            sums.sum[1].add(m.mass[c] * m.energy[c]);
          }
    // a node belongs to the rank that owns the first cell around it
    for (Index n = 0; n < mesh.n_nodes; ++n)
      if (state.node_mass[n] != 0. &&
          mesh.node_corner[mesh.node_corner_begin[n]] < mesh.n_owned * FlatMesh<dim>::corners)
        sums.add_corner(state.node_mass[n], node_velocity(state, n));
    ExactSum::reduce(sums.sum, communicator);
    return sums.amounts();
  }

  template <int dim>
  ConservedTotals<dim>
  cell_sum(const FlatMesh<dim> &mesh, const State<dim> &state, const std::function<bool(Index cell)> &belongs,
           MPI_Comm communicator)
  {
    const CornerVelocities<dim> velocities = corner_velocities(mesh, state);
    ExactTotals<dim>            sums;
    for (Index c = 0; c < mesh.n_owned; ++c)
      if (belongs(c))
        sums.add(cell_totals<dim>(state, velocities, c));
    ExactSum::reduce(sums.sum, communicator);
    return sums.amounts();
  }

  template <int dim>
  std::vector<ConservedTotals<dim>>
  body_totals(const FlatMesh<dim> &mesh, const State<dim> &state, const std::vector<int> &tag,
              const std::vector<Index> &material, MPI_Comm communicator)
  {
    constexpr int                 corners  = FlatMesh<dim>::corners;
    const std::size_t             n_bodies = tag.size();
    std::vector<ExactTotals<dim>> sums(n_bodies);
    std::vector<double>           part(n_bodies);
    for (Index c = 0; c < mesh.n_owned; ++c)
      for (std::size_t m = 0; m < state.material.size(); ++m)
        {
          const MaterialState &material_state = state.material[m];
          const double         mass           = material_state.mass[c];
          if (mass == 0.)
            continue;
          body_shares(tag, material, static_cast<Index>(m), part,
                      [&](int field) { return material_state.fields[field].value[c]; });
          for (std::size_t b = 0; b < n_bodies; ++b)
            {
              const double share = part[b];
              if (share == 0.)
                continue;
              sums[b].sum[0].add(share * mass);
              sums[b].sum[1].add(share * mass * material_state.energy[c]);
              for (int k = 0; k < corners; ++k)
                sums[b].add_corner(share * mass * state.corner_weight[c * corners + k],
                                   node_velocity(state, mesh.cell_node[c * corners + k]));
            }
        }
    std::vector<ConservedTotals<dim>> result;
    for (ExactTotals<dim> &s : sums)
      {
        ExactSum::reduce(s.sum, communicator);
        result.push_back(s.amounts());
      }
    return result;
  }

  template <int dim>
  ConservedTotals<dim>
  totals(const CellPacketLayout<dim> &layout, const std::vector<Waiting<dim>> &parts)
  {
    ExactTotals<dim> sums;
    for (const Waiting<dim> &part : parts)
      {
        const CellPacket &packet = part.element.packet;
        for (int m = 0; m < layout.n_materials(); ++m)
          {
            sums.sum[0].add(packet[layout.mass(m)]);
            sums.sum[1].add(packet[layout.mass(m)] * packet[layout.energy(m)]);
          }
        sums.sum[2].add(packet[layout.kinetic_remainder()]);
        for (int k = 0; k < Element<dim>::corners; ++k)
          sums.add_corner(part.element.corner_mass[k], corner_velocity(layout, packet, k));
      }
    return sums.amounts();
  }

  template <int dim>
  std::vector<ConservedTotals<dim>>
  body_totals(const CellPacketLayout<dim> &layout, const std::vector<Waiting<dim>> &parts, const std::vector<int> &tag,
              const std::vector<Index> &material)
  {
    std::vector<ExactTotals<dim>> sums(tag.size());
    std::vector<double>           share(tag.size());
    for (const Waiting<dim> &waiting : parts)
      {
        const Element<dim> &element = waiting.element;
        const CellPacket   &packet  = element.packet;
        double              whole   = 0;
        for (const double corner : element.corner_mass)
          whole += corner;
        for (int m = 0; m < layout.n_materials(); ++m)
          {
            const double mass = packet[layout.mass(m)];
            body_shares(tag, material, static_cast<Index>(m), share,
                        [&](int field) { return packet[layout.field(m, field)]; });
            for (std::size_t b = 0; b < tag.size(); ++b)
              {
                sums[b].sum[0].add(share[b] * mass);
                sums[b].sum[1].add(share[b] * mass * packet[layout.energy(m)]);
                for (int k = 0; k < Element<dim>::corners; ++k)
                  sums[b].add_corner(share[b] * mass * (element.corner_mass[k] / whole),
                                     corner_velocity(layout, packet, k));
              }
          }
      }
    std::vector<ConservedTotals<dim>> result;
    for (const ExactTotals<dim> &s : sums)
      result.push_back(s.amounts());
    return result;
  }

  template ConservedTotals<2>
  totals(const FlatMesh<2> &, const State<2> &, MPI_Comm);
  template ConservedTotals<2>
  totals(const CellPacketLayout<2> &, const std::vector<Waiting<2>> &);
  template std::vector<ConservedTotals<2>>
  body_totals(const CellPacketLayout<2> &, const std::vector<Waiting<2>> &, const std::vector<int> &,
              const std::vector<Index> &);
  template ConservedTotals<2>
  cell_sum(const FlatMesh<2> &, const State<2> &, const std::function<bool(Index)> &, MPI_Comm);
  template std::vector<ConservedTotals<2>>
  body_totals(const FlatMesh<2> &, const State<2> &, const std::vector<int> &, const std::vector<Index> &, MPI_Comm);
} // namespace whipple
