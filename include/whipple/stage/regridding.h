// SPDX-License-Identifier: LGPL-2.1-or-later
#pragma once

#include <whipple/mesh/refinement_map.h>
#include <whipple/remap/directional_remap.h>
#include <whipple/scene/scene.h>
#include <whipple/stage/domain.h>

namespace whipple
{
  /// Layers of neighbours around a rank's cells that stay valid between two halo exchanges: what the greediest
  /// kernel of the cycle, one sweep of the remap, uses up.
  template <int dim>
  inline constexpr int halo_width = DirectionalRemap<dim>::halo_layers;

  /// Keeps the mesh where the material is: which level where, and the transfer of what the cells hold.
  template <int dim>
  class Regridding
  {
  public:
    Regridding(const Scene<dim> &scene, const FieldLayout &layout);

    /// Level that material of a solid fraction s = sum V_m (1 - phi_m) / sum V_m needs: the finest if it is dense,
    /// whatever part of the cell it fills, one level less below MeshControl::solid_fraction, one more for each factor
    /// solid_ratio.
    int
    wanted_level(double solid_fraction) const;

    /// Solid fraction of the material in a cell, 1 without voids, 0 without material.
    static double
    solid_fraction(const State<dim> &state, Index cell);

    /// Whether nothing has reached a cell yet: solid without pores, at rest and free of stress (MeshControl). Its state
    /// is uniform and its interface plane, so coarse cells hold it as well as fine ones.
    bool
    is_quiet(const FlatMesh<dim> &mesh, const State<dim> &state, Index cell) const;

    /// Refine the forest to a synchronised map, without contents, and flatten what the map touches.
    void
    build(Domain<dim> &domain, const RefinementMap<dim> &map) const;

    /// Whether the mesh still serves: every cell has the level it needs, and active cells around it, within half the
    /// buffer. Collective. A regrid costs as much as dozens of steps; this costs less than one.
    bool
    serves(const Domain<dim> &domain) const;

    /// Follow the material: refine, coarsen and repartition with all contents, flatten anew.
    /// @param entering bodies about to be painted, for which the mesh is prepared as well
    /// @returns kinetic energy that velocity averaging turned into heat (or dropped), all ranks, Mbar cm^3
    double
    regrid(Domain<dim> &domain, KineticLoss loss, std::span<const std::size_t> entering = {}) const;

    /// Cells next to the edge of the active region (and their neighbours): no material may be in them when a step
    /// begins, or it could leave the region.
    static std::vector<Index>
    guard_cells(const FlatMesh<dim> &mesh);

  private:
    /// Ask for what every owned cell needs.
    void
    request_cells(const Domain<dim> &domain, int buffer, RefinementMap<dim> &map) const;
    std::uint8_t
    target(const RefinementMap<dim> &map, CellKey leaf) const;
    void
    flatten(Domain<dim> &domain, const RefinementMap<dim> &map) const;

    const Scene<dim>  &scene_;
    const FieldLayout &layout_;
    int                quiet_levels_; ///< that undisturbed material gives up
  };
} // namespace whipple
