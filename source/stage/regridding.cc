// SPDX-License-Identifier: LGPL-2.1-or-later
#include <whipple/hydro/lagrange_step.h>
#include <whipple/remap/cell_split.h>
#include <whipple/remap/interface_normal.h>
#include <whipple/stage/collective.h>
#include <whipple/stage/painting.h>
#include <whipple/stage/regridding.h>

#include <algorithm>
#include <cmath>
#include <limits>

namespace whipple
{
  namespace
  {
    /// Work of a leaf for the partition: empty ones are mostly cells of the buffer, which cost about half a step.
    unsigned int
    leaf_weight(const CellPacket &packet)
    {
      return packet.empty() ? 10 : 20;
    }
  } // namespace

  namespace
  {
    /// Levels that undisturbed material may give up: the thinnest body must keep `least_cells` cells, or cells with
    /// void on both sides would not know where in them the material is.
    template <int dim>
    int
    quiet_levels(const Scene<dim> &scene)
    {
      constexpr double least_cells = 2.5;
      double           thinnest    = std::numeric_limits<double>::infinity();
      for (const Body<dim> &body : scene.bodies)
        {
          const Box<dim> box = extent(body.shape);
          for (int d = 0; d < dim; ++d)
            thinnest = std::min(thinnest, box.upper[d] - box.lower[d]);
        }
      const double levels = std::floor(std::log2(thinnest / (least_cells * scene.lattice.spacing)));
      return static_cast<int>(std::clamp<double>(levels, 0, scene.mesh.quiet_levels));
    }
  } // namespace

  template <int dim>
  Regridding<dim>::Regridding(const Scene<dim> &scene, const FieldLayout &layout)
    : scene_(scene)
    , layout_(layout)
    , quiet_levels_(quiet_levels(scene))
  {
  }

  template <int dim>
  int
  Regridding<dim>::wanted_level(double solid_fraction) const
  {
    const int finest = scene_.lattice.max_level;
    if (solid_fraction >= scene_.mesh.solid_fraction)
      return finest;
    const double below = std::log(solid_fraction / scene_.mesh.solid_fraction) / std::log(scene_.mesh.solid_ratio);
    return below >= finest ? 0 : finest - 1 - static_cast<int>(below);
  }

  template <int dim>
  double
  Regridding<dim>::solid_fraction(const State<dim> &state, Index cell)
  {
    double solid = 0, volume = 0;
    for (const MaterialState &m : state.material)
      {
        volume += m.volume[cell];
        solid += m.volume[cell] * (m.has_voids() ? 1. - m.void_fraction[cell] : 1.);
      }
    return volume > 0 ? solid / volume : 0.;
  }

  template <int dim>
  bool
  Regridding<dim>::is_quiet(const FlatMesh<dim> &mesh, const State<dim> &state, Index cell) const
  {
    const double slow = scene_.mesh.quiet_velocity;
    for (int k = 0; k < FlatMesh<dim>::corners; ++k)
      for (int d = 0; d < dim; ++d)
        if (std::abs(state.velocity[d][mesh.cell_node[cell * FlatMesh<dim>::corners + k]]) > slow)
          return false;
    for (const MaterialState &m : state.material)
      {
        if (m.mass[cell] == 0.)
          continue;
        const double weak = m.density[cell] * m.sound_speed[cell] * slow;
        bool         calm = std::abs(m.pressure[cell]) <= weak && !(m.has_voids() && m.void_fraction[cell] > 0);
        for (const int s : {state.index.stress_00, state.index.stress_11, state.index.stress_01})
          calm = calm && (s < 0 || std::abs(m.fields[s].value[cell]) <= weak);
        if (!calm)
          return false;
      }
    return true;
  }

  template <int dim>
  std::uint8_t
  Regridding<dim>::target(const RefinementMap<dim> &map, CellKey leaf) const
  {
    return scene_.mesh.refinement == Refinement::uniform ? static_cast<std::uint8_t>(scene_.lattice.max_level)
                                                         : map.target_level(leaf);
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
    const FlatMesh<dim> &mesh = domain.view->mesh;
    for (Index c = 0; c < mesh.n_owned; ++c)
      {
        const double solid = solid_fraction(domain.state, c);
        if (solid == 0.)
          continue;
        LatticePoint<dim> lower = key_point<dim>(mesh.key[c]), upper = lower;
        for (int d = 0; d < dim; ++d)
          upper[d] += scene_.lattice.extent(mesh.level[c]);
        int level = wanted_level(solid);
        if (is_quiet(mesh, domain.state, c))
          level = std::max(0, level - quiet_levels_);
        map.request(level, lower, upper, buffer);
      }
  }

  template <int dim>
  bool
  Regridding<dim>::serves(const Domain<dim> &domain) const
  {
    RefinementMap<dim> map(scene_.lattice);
    request_cells(domain, scene_.mesh.buffer / 2, map);
    map.synchronise(domain.communicator());
    const auto                leaves = domain.forest.leaves();
    std::vector<std::uint8_t> active(leaves.size(), 0);
    for (const Index leaf : domain.view->leaf_of_cell)
      active[leaf] = 1;
    int served = 1;
    for (std::size_t i = 0; i < leaves.size() && served; ++i)
      served = key_level(leaves[i]) >= target(map, leaves[i]) && (active[i] || !map.touched(leaves[i]));
    MPI_Allreduce(MPI_IN_PLACE, &served, 1, MPI_INT, MPI_MIN, domain.communicator());
    return served;
  }

  template <int dim>
  double
  Regridding<dim>::regrid(Domain<dim> &domain, KineticLoss loss, std::span<const std::size_t> entering) const
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
    request_bodies(scene_, entering, map);
    map.synchronise(communicator);

    const PacketRemap<dim> remap = CellSplit<dim>(scene_.lattice, layout).packet_remap();
    domain.forest.adapt_until([&](CellKey leaf) { return target(map, leaf); }, packets, remap, leaf_weight);
    flatten(domain, map);

    return unpack_leaves(layout_, layout, packets, scene_.boundaries, loss, domain);
  }

  template <int dim>
  std::vector<Index>
  Regridding<dim>::guard_cells(const FlatMesh<dim> &mesh)
  {
    std::vector<std::uint8_t> guard(mesh.n_cells, 0);
    for (const FlatFaces<dim> &faces : mesh.faces)
      for (Index f = 0; f < faces.size(); ++f)
        for (int s = 0; s < 2; ++s)
          if (faces.cell[s][f] == none && faces.side[f] == -1)
            guard[faces.cell[1 - s][f]] = 1;
    for (const FlatFaces<dim> &faces : mesh.faces)
      for (Index f = 0; f < faces.size(); ++f)
        for (int s = 0; s < 2; ++s)
          {
            const Index a = faces.cell[s][f], b = faces.cell[1 - s][f];
            if (a != none && b != none && guard[a] == 1 && guard[b] == 0)
              guard[b] = 2;
          }
    std::vector<Index> cells;
    for (Index c = 0; c < mesh.n_owned; ++c)
      if (guard[c])
        cells.push_back(c);
    return cells;
  }

  template class Regridding<2>;
} // namespace whipple
