// SPDX-License-Identifier: LGPL-2.1-or-later
#include <whipple/hydro/lagrange_step.h>
#include <whipple/initial/painting.h>
#include <whipple/mesh/collective.h>
#include <whipple/remap/cell_split.h>
#include <whipple/remap/interface_normal.h>
#include <whipple/run/regridding.h>
#include <whipple/state/conversion.h>

#include <array>
#include <cmath>

namespace whipple
{
  namespace
  {
    const ConversionRegistration registration({50, Regridding<2>::cause}, ConversionListed::at_end);

    /// Work of a leaf for the partition: empty ones are mostly cells of the buffer, which cost about half a step.
    unsigned int
    leaf_weight(const CellPacket &packet)
    {
      return packet.empty() ? 10 : 20;
    }
  } // namespace

  template <int dim>
  Regridding<dim>::Regridding(const Scene<dim> &scene, const FieldLayout &layout)
    : scene_(scene)
    , layout_(layout)
    , need_(scene, layout)
  {
  }

  template <int dim>
  std::uint8_t
  Regridding<dim>::target(const RefinementMap<dim> &map, CellKey leaf) const
  {
    return scene_.mesh.refinement == Refinement::adaptive ? map.target_level(leaf) : need_.fixed(leaf);
  }

  template <int dim>
  void
  Regridding<dim>::flatten(Domain<dim> &domain, const RefinementMap<dim> &map) const
  {
    const auto                leaves = domain.forest.leaves();
    std::vector<std::uint8_t> active(leaves.size());
    for (std::size_t i = 0; i < leaves.size(); ++i)
      active[i] = map.touched(leaves[i]);
    domain.view = domain.forest.flatten(active, halo_width<dim>, Cohesion::bonded);
    clear_state(layout_, domain);
  }

  template <int dim>
  void
  Regridding<dim>::build(Domain<dim> &domain, const RefinementMap<dim> &map) const
  {
    std::vector<CellPacket> packets(domain.forest.leaves().size());
    domain.forest.adapt_until([&](CellKey leaf) { return target(map, leaf); }, packets, PacketRemap<dim>{});
    // nothing to weigh yet but what will be active: a packet of one number marks it
    for (std::size_t i = 0; i < packets.size(); ++i)
      if (map.touched(domain.forest.leaves()[i]))
        packets[i] = {1.};
    domain.forest.repartition(packets, leaf_weight);
    flatten(domain, map);
  }

  template <int dim>
  void
  Regridding<dim>::request_cells(const Domain<dim> &domain, int buffer, RefinementMap<dim> &map) const
  {
    const FlatMesh<dim>   &mesh   = domain.view->mesh;
    const std::vector<int> levels = need_.of_cells(mesh, domain.state, domain.derived, domain.communicator());
    for (Index c = 0; c < mesh.n_owned; ++c)
      {
        if (levels[c] < 0)
          continue;
        LatticePoint<dim> lower = key_point<dim>(mesh.key[c]), upper = lower;
        for (int d = 0; d < dim; ++d)
          upper[d] += scene_.lattice.extent(mesh.level[c]);
        map.request(levels[c], lower, upper, buffer);
      }
  }

  template <int dim>
  typename Regridding<dim>::Fit
  Regridding<dim>::fit(const Domain<dim> &domain) const
  {
    RefinementMap<dim> map(scene_.lattice);
    request_cells(domain, scene_.mesh.buffer / 2, map);
    map.synchronise(domain.communicator());
    const auto                leaves = domain.forest.leaves();
    std::vector<std::uint8_t> active(leaves.size(), 0);
    for (const Index leaf : domain.view->leaf_of_cell)
      active[leaf] = 1;
    std::array<double, 3> counts{}; // leaves too coarse or not active where needed, active ones, those saved
    for (std::size_t i = 0; i < leaves.size(); ++i)
      {
        const int level = key_level(leaves[i]), wanted = target(map, leaves[i]);
        counts[0] += level < wanted || (!active[i] && map.touched(leaves[i]));
        counts[1] += active[i];
        if (active[i] && wanted < level)
          counts[2] += 1. - std::pow(0.5, dim * (level - wanted));
      }
    MPI_Allreduce(MPI_IN_PLACE, counts.data(), 3, MPI_DOUBLE, MPI_SUM, domain.communicator());
    return {counts[0] == 0., counts[1] > 0. ? counts[2] / counts[1] : 0.};
  }

  template <int dim>
  Booking<dim>
  Regridding<dim>::regrid(Domain<dim> &domain, KineticLoss loss, std::span<const std::size_t> entering,
                          const std::function<void(RefinementMap<dim> &)> &also) const
  {
    const MPI_Comm          communicator = domain.communicator();
    const FlatMesh<dim>    &mesh         = domain.view->mesh;
    const auto              layout       = CellPacketLayout<dim>::of(domain.state);
    RefinementMap<dim>      map(scene_.lattice);
    std::vector<CellPacket> packets(domain.forest.leaves().size());
    {
      const InterfaceNormals<dim> normals = interface_normals(mesh, domain.state);
      const CornerVelocities<dim> corners = corner_velocities(mesh, domain.state);
      for (Index c = 0; c < mesh.n_owned; ++c)
        packets[domain.view->leaf_of_cell[c]] = pack<dim>(layout, domain.state, c, corners, normals);
    }
    request_cells(domain, scene_.mesh.buffer, map);
    request_bodies(scene_, &need_, entering, map);
    if (also)
      also(map);
    map.synchronise(communicator);

    const PacketRemap<dim> remap = CellSplit<dim>(scene_.lattice, layout).packet_remap();
    domain.forest.adapt_until([&](CellKey leaf) { return target(map, leaf); }, packets, remap, leaf_weight);
    flatten(domain, map);

    return unpack_leaves(layout_, layout, packets, scene_.boundaries, loss, domain);
  }

  template <int dim>
  std::vector<Index>
  Regridding<dim>::edge_cells(const FlatMesh<dim> &mesh)
  {
    std::vector<std::uint8_t> edge(mesh.n_cells, 0);
    for (const FlatFaces<dim> &faces : mesh.faces)
      for (Index f = 0; f < faces.size(); ++f)
        for (int s = 0; s < 2; ++s)
          if (faces.cell[s][f] == none && faces.side[f] == -1)
            edge[faces.cell[1 - s][f]] = 1;
    for (const FlatFaces<dim> &faces : mesh.faces)
      for (Index f = 0; f < faces.size(); ++f)
        for (int s = 0; s < 2; ++s)
          {
            const Index a = faces.cell[s][f], b = faces.cell[1 - s][f];
            if (a != none && b != none && edge[a] == 1 && edge[b] == 0)
              edge[b] = 2;
          }
    std::vector<Index> cells;
    for (Index c = 0; c < mesh.n_owned; ++c)
      if (edge[c])
        cells.push_back(c);
    return cells;
  }

  template <int dim>
  std::vector<std::uint8_t>
  Regridding<dim>::edge_flags(const FlatPartition<dim> &view)
  {
    std::vector<double> edge(view.mesh.n_cells, 0.);
    for (const Index c : edge_cells(view.mesh))
      edge[c] = 1.;
    view.halo.exchange(std::vector<std::vector<double> *>{&edge}, {});
    return {edge.begin(), edge.end()};
  }

  template class Regridding<2>;
} // namespace whipple
