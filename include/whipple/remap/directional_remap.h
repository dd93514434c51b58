// SPDX-License-Identifier: LGPL-2.1-or-later
#pragma once

#include <whipple/mesh/boundary.h>
#include <whipple/mesh/flat_mesh.h>
#include <whipple/remap/material_transport.h>
#include <whipple/remap/momentum_transport.h>
#include <whipple/remap/remap_parameters.h>
#include <whipple/remap/remap_sums.h>
#include <whipple/remap/sweep_topology.h>
#include <whipple/remap/volume_flux.h>
#include <whipple/state/fields.h>

#include <array>
#include <vector>

namespace whipple
{
  /// The largest step of the remap and the cell that sets it.
  struct AdvectionLimit
  {
    double dt;   ///< us
    Index  cell; ///< none if nothing moves
  };

  /// Remap of a moved state back to the undeformed mesh by directional sweeps over swept volumes
  /// (equations: doc/theory/remap.md). A step is
  ///
  ///     begin(state); sweep(state, first axis); exchange; sweep(state, other axis); exchange; finish(state);
  ///
  /// with the first axis alternating from step to step. A sweep leaves the owned cells and their nodes right when
  /// the halo is `halo_layers` wide; what is to be exchanged after it: material volume, mass, density, energy, phi
  /// and fields, node velocity and node mass (cell volumes need none).
  ///
  /// Corner weights are shares of the cell's mass (sum 1 in every cell) and belong to the undeformed mesh. Nodes that
  /// hold no mass leave with velocity 0. Rebuild after every regrid (the mesh is referred to, not copied).
  template <int dim>
  class DirectionalRemap
  {
  public:
    /// Halo layers one sweep consumes.
    static constexpr int halo_layers = 5;

    DirectionalRemap(const FlatMesh<dim> &mesh, const Boundaries<dim> &boundaries, const RemapParameters &parameters);

    /// Largest step [us] for which no node moves more than advection_limit edges of a cell around it; over owned
    /// cells. Infinity when nothing moves.
    AdvectionLimit
    time_step(const State<dim> &state) const;

    /// Swept volumes of every subface between state.position and the undeformed mesh.
    void
    begin(const State<dim> &state);

    /// Move material through the faces normal to `axis`; updates cell volumes, materials (volume, mass, density,
    /// energy, phi, fields), node velocities and masses.
    /// @param halo collective: the ranks meet once, and more often where nodes are drained on any of them
    /// @throws StateError where an owned cell would give away more than it holds (step too long), or material
    ///   would cross the end of the active region.
    RemapSums<dim>
    sweep(State<dim> &state, int axis, const MeetingHalo<dim> &halo = {});

    /// Nodes back to the undeformed mesh, exact volumes; cells full within 1e-10 become exactly full.
    /// @throws StateError where an owned cell's swept volumes do not add up to its volume.
    void
    finish(State<dim> &state);

    /// Signed swept volumes of the faces normal to `axis`: gained by the cell below the face [cm^3].
    const std::vector<double> &
    swept_volume(int axis) const
    {
      return swept_[axis];
    }

  private:
    const FlatMesh<dim>  *mesh_;
    const RemapParameters parameters_;
    std::vector<double>   fixed_volume_;             ///< [n_cells] of the undeformed cells
    std::vector<double>   mass_before_, mass_after_; ///< [n_cells] all materials, around a sweep
    std::vector<double>   mass_flux_;                ///< [faces + 1] all materials, along + axis

    std::array<SweepTopology<dim>, dim>  topology_;
    std::array<std::vector<double>, dim> swept_; ///< [faces + 1], the last entry is 0
    VolumeFlux<dim>                      volume_flux_;
    MaterialTransport<dim>               material_transport_;
    MomentumTransport<dim>               momentum_transport_;
  };
} // namespace whipple
