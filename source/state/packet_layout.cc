// SPDX-License-Identifier: LGPL-2.1-or-later
#include <whipple/state/packet_layout.h>

#include <whipple/error.h>
#include <whipple/mesh/cell_corners.h>

#include <numeric>

namespace whipple
{
  template <int dim>
  CellPacketLayout<dim>
  CellPacketLayout<dim>::of(const State<dim> &state)
  {
    CellPacketLayout layout;
    for (const MaterialState &material : state.material)
      layout.has_voids.push_back(material.has_voids());
    if (!state.material.empty())
      for (const Field &field : state.material.front().fields)
        layout.carrier.push_back(field.description.carrier);
    return layout;
  }

  template <int dim>
  CellPacket
  pack(const CellPacketLayout<dim> &layout, const State<dim> &state, Index cell,
       const CornerVelocities<dim> &velocities, const InterfaceNormals<dim> &normals)
  {
    if (cell_mass<dim>(state, cell) == 0)
      return {};
    constexpr int corners = 1 << dim;
    CellPacket    packet(layout.size());
    for (int d = 0; d < dim; ++d)
      for (int k = 0; k < corners; ++k)
        packet[layout.velocity(d, k)] = velocities.velocity[d][cell * corners + k];
    packet[layout.kinetic_remainder()] = velocities.kinetic_remainder[cell];
    for (int m = 0; m < layout.n_materials(); ++m)
      {
        const MaterialState &material   = state.material[m];
        packet[layout.volume(m)]        = material.volume[cell];
        packet[layout.mass(m)]          = material.mass[cell];
        packet[layout.density(m)]       = material.density[cell];
        packet[layout.energy(m)]        = material.energy[cell];
        packet[layout.void_fraction(m)] = layout.has_voids[m] ? material.void_fraction[cell] : 0.;
        for (int d = 0; d < dim; ++d)
          packet[layout.normal(m, d)] = normals[m][d][cell];
        for (int f = 0; f < layout.n_fields(); ++f)
          packet[layout.field(m, f)] = material.fields[f].value[cell];
      }
    return packet;
  }

  template <int dim>
  void
  unpack(const CellPacketLayout<dim> &layout, std::span<const double> packet, State<dim> &state, Index cell,
         CornerVelocities<dim> &velocities)
  {
    constexpr int corners = 1 << dim;
    if (!packet.empty() && packet.size() != static_cast<std::size_t>(layout.size()))
      throw StateError("cell packet of " + std::to_string(packet.size()) + " doubles where the layout has " +
                       std::to_string(layout.size()));
    const auto value = [&](int slot) { return packet.empty() ? 0. : packet[slot]; };

    for (int d = 0; d < dim; ++d)
      for (int k = 0; k < corners; ++k)
        velocities.velocity[d][cell * corners + k] = value(layout.velocity(d, k));
    velocities.kinetic_remainder[cell] = value(layout.kinetic_remainder());
    for (int m = 0; m < layout.n_materials(); ++m)
      {
        MaterialState &material = state.material[m];
        material.volume[cell]   = value(layout.volume(m));
        material.mass[cell]     = value(layout.mass(m));
        material.density[cell]  = value(layout.density(m));
        material.energy[cell]   = value(layout.energy(m));
        if (layout.has_voids[m])
          material.void_fraction[cell] = value(layout.void_fraction(m));
        for (int f = 0; f < layout.n_fields(); ++f)
          material.fields[f].value[cell] = value(layout.field(m, f));
      }
  }

  namespace
  {
    /// True volumes and corner weights (shares of the integrals of N_k) of the undeformed cells.
    template <int dim>
    void
    measure_cells(const FlatMesh<dim> &mesh, State<dim> &state)
    {
      for (Index cell = 0; cell < mesh.n_cells; ++cell)
        {
          const CornerVectors<dim> x      = cell_corners(mesh, mesh.node_point, cell);
          const CornerValues<dim>  weight = corner_volume<dim>(mesh.symmetry, x);
          const double             sum    = std::accumulate(weight.begin(), weight.end(), 0.);
          state.volume[cell]              = cell_volume<dim>(mesh.symmetry, x);
          for (std::size_t k = 0; k < weight.size(); ++k)
            state.corner_weight[cell * weight.size() + k] = weight[k] / sum;
        }
    }
  } // namespace

  template <int dim>
  State<dim>
  empty_state_like(const State<dim> &like, const FlatMesh<dim> &mesh)
  {
    const std::size_t cells = mesh.n_cells, nodes = mesh.n_nodes;
    State<dim>        state;
    state.time     = like.time;
    state.index    = like.index;
    state.position = mesh.node_point;
    for (auto &v : state.velocity)
      v.assign(nodes, 0.);
    state.node_mass.assign(nodes, 0.);
    state.volume.resize(cells);
    state.corner_weight.resize(cells << dim);
    measure_cells(mesh, state);

    for (const MaterialState &source : like.material)
      {
        MaterialState &target = state.material.emplace_back();
        for (auto *array : {&target.volume, &target.mass, &target.density, &target.energy})
          array->assign(cells, 0.);
        target.carries_voids = source.has_voids();
        if (target.carries_voids)
          target.void_fraction.assign(cells, 0.);
        for (const Field &field : source.fields)
          target.fields.push_back({field.description, std::vector<double>(cells, 0.)});
      }
    return state;
  }

  template struct CellPacketLayout<2>;
  template CellPacket
  pack<2>(const CellPacketLayout<2> &, const State<2> &, Index, const CornerVelocities<2> &,
          const InterfaceNormals<2> &);
  template void
  unpack<2>(const CellPacketLayout<2> &, std::span<const double>, State<2> &, Index, CornerVelocities<2> &);
  template State<2>
  empty_state_like<2>(const State<2> &, const FlatMesh<2> &);
} // namespace whipple
