// SPDX-License-Identifier: LGPL-2.1-or-later
#pragma once

#include <whipple/mesh/refinement_map.h>
#include <whipple/problem/level_need.h>
#include <whipple/remap/directional_remap.h>
#include <whipple/run/domain.h>
#include <whipple/scene/scene.h>

#include <functional>

namespace whipple
{
  /// Layers of neighbours around a rank's cells that stay valid between two halo exchanges: what the kernel that
  /// needs most of them, one sweep of the remap, uses up.
  template <int dim>
  inline constexpr int halo_width = DirectionalRemap<dim>::halo_layers;

  /// Keeps the mesh where the material is: which level where, and the transfer of what the cells hold.
  template <int dim>
  class Regridding
  {
  public:
    Regridding(const Scene<dim> &scene, const FieldLayout &layout);

    /// What level what needs.
    const LevelNeed<dim> &
    need() const
    {
      return need_;
    }

    /// Refine the forest to a synchronised map, without contents, and flatten what the map touches.
    void
    build(Domain<dim> &domain, const RefinementMap<dim> &map) const;

    /// How the mesh fits what it holds.
    struct Fit
    {
      bool   suffices = true; ///< every cell has the level it needs, and active cells around it, within half the buffer
      double spare    = 0;    ///< part of the active cells that a mesh no finer than needed would save
    };

    /// Reads domain.derived. Collective. A regrid costs as much as dozens of steps; this costs less than one.
    Fit
    fit(const Domain<dim> &domain) const;

    /// What a regrid is called in the books.
    static constexpr const char *cause = "regrid";

    /// Follow the material: refine, coarsen and repartition with all contents, flatten anew. Reads domain.derived.
    /// @param entering bodies about to be painted, for which the mesh is prepared as well
    /// @param also     asks for more; null: nothing
    /// @returns what the averaging of velocities lost and the walls took, all ranks
    Booking<dim>
    regrid(Domain<dim> &domain, KineticLoss loss, std::span<const std::size_t> entering = {},
           const std::function<void(RefinementMap<dim> &)> &also = {}) const;

    /// Cells next to the edge of the active region (and their neighbours): no material may be in them when a step
    /// begins, or it could leave the region.
    static std::vector<Index>
    edge_cells(const FlatMesh<dim> &mesh);
    /// The same as a flag for each owned and halo cell. Collective.
    static std::vector<std::uint8_t>
    edge_flags(const FlatPartition<dim> &view);

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
    LevelNeed<dim>     need_;
  };
} // namespace whipple
